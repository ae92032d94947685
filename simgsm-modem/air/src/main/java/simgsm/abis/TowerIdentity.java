package simgsm.abis;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.octets.Bounds;

/**
 * The identity sent by a tower to the centre: the unit id, and the cell's parameters in the unit name, as {@code
 * "west arfcn=100 bsic=10 lac=1 cell=6969 tch=6 timeout=32 access=0 hysteresis=4"}. osmo-bsc reads only the unit id
 * and has the rest in its configuration.
 *
 * @param frequency ARFCN of the one carrier, 0 to 1023
 * @param identityCode BSIC, 0 to 63
 * @param area location area code, 0 to 65535
 * @param cellIdentity 0 to 65535
 * @param trafficChannels timeslots for speech, 1 to 7
 * @param radioLinkTimeout SACCH blocks, 4 to 64 in steps of 4
 * @param accessMinimum RXLEV_ACCESS_MIN, 0 to 63
 * @param hysteresisDecibels CELL_RESELECT_HYSTERESIS, 0 to 14 in steps of 2
 */
public record TowerIdentity(
        String unitId,
        String name,
        int frequency,
        int identityCode,
        int area,
        int cellIdentity,
        int trafficChannels,
        int radioLinkTimeout,
        int accessMinimum,
        int hysteresisDecibels) {
    private static final Pattern UNIT_ID = Pattern.compile("([0-9]{1,5})/[0-9]{1,5}/[0-9]{1,5}");
    private static final int FIRST_FREQUENCY = 100;
    private static final int FREQUENCY_STEP = 10;
    private static final int FIRST_IDENTITY_CODE = 10;
    private static final int IDENTITY_CODES = 64;
    private static final int HIGHEST_FREQUENCY = 124;
    private static final int MOST_TRAFFIC_CHANNELS = 7;
    private static final int STANDARD_TIMEOUT = 32;
    private static final int STANDARD_HYSTERESIS_DECIBELS = 4;

    public TowerIdentity {
        Bounds.check("ARFCN", frequency, 0, 1023);
        Bounds.check("BSIC", identityCode, 0, IDENTITY_CODES - 1);
        Bounds.check("location area code", area, 0, 0xffff);
        Bounds.check("cell identity", cellIdentity, 0, 0xffff);
        Bounds.check("traffic channels", trafficChannels, 1, MOST_TRAFFIC_CHANNELS);
        Bounds.check("radio link time-out", radioLinkTimeout, 4, 64);
        Bounds.check("RXLEV_ACCESS_MIN", accessMinimum, 0, 63);
        Bounds.check("hysteresis", hysteresisDecibels, 0, 14);
    }

    /** The identity as a message. */
    public CcmMessage.IdentityResponse response() {
        String text = name
                + " arfcn=" + frequency
                + " bsic=" + identityCode
                + " lac=" + area
                + " cell=" + cellIdentity
                + " tch=" + trafficChannels
                + " timeout=" + radioLinkTimeout
                + " access=" + accessMinimum
                + " hysteresis=" + hysteresisDecibels;
        return new CcmMessage.IdentityResponse(text, "", unitId);
    }

    /**
     * The identity in a tower's answer.
     *
     * @param position of the tower in its controller, for missing parameters: ARFCN 100, 110 ... and BSIC 10, 11 ...
     * @throws IllegalArgumentException naming the parameter that is out of its range
     */
    public static TowerIdentity of(CcmMessage.IdentityResponse response, int position) {
        Matcher unit = UNIT_ID.matcher(response.unitId());
        if (!unit.matches()) {
            throw new IllegalArgumentException(
                    "unit id " + response.unitId() + " where SITE/BTS/TRX, as 6969/0/0, was expected");
        }
        String text = response.unitName();
        int space = text.indexOf(' ');
        String name = space > 0 ? text.substring(0, space) : text.isEmpty() ? unit.group(1) : text;
        int frequency = FIRST_FREQUENCY + FREQUENCY_STEP * position;
        return new TowerIdentity(
                response.unitId(),
                name.contains("=") ? unit.group(1) : name,
                value(text, "arfcn", frequency <= HIGHEST_FREQUENCY ? frequency : 1 + position % HIGHEST_FREQUENCY),
                value(text, "bsic", (FIRST_IDENTITY_CODE + position) % IDENTITY_CODES),
                value(text, "lac", 1),
                value(text, "cell", Integer.parseInt(unit.group(1)) & 0xffff),
                value(text, "tch", MOST_TRAFFIC_CHANNELS),
                value(text, "timeout", STANDARD_TIMEOUT),
                value(text, "access", 0),
                value(text, "hysteresis", STANDARD_HYSTERESIS_DECIBELS));
    }

    private static int value(String text, String key, int otherwise) {
        Matcher found =
                Pattern.compile("(?:^|\\s)" + key + "=([0-9]{1,5})(?=\\s|$)").matcher(text);
        return found.find() ? Integer.parseInt(found.group(1)) : otherwise;
    }
}
