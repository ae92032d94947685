package simgsm.air;

import simgsm.octets.Bounds;

/**
 * Location area identification (TS 24.008, 10.5.1.3).
 *
 * @param countryCode three digits
 * @param networkCode two or three digits
 * @param areaCode 0 to 65535
 */
public record LocationArea(String countryCode, String networkCode, int areaCode) {
    /** The one area of the test network. */
    public static final LocationArea TEST = new LocationArea("001", "01", 1);

    public LocationArea {
        if (!countryCode.matches("[0-9]{3}") || !networkCode.matches("[0-9]{2,3}")) {
            throw new IllegalArgumentException(countryCode + "/" + networkCode + " is not MCC/MNC");
        }
        Bounds.check("location area code", areaCode, 0, 0xffff);
    }
}
