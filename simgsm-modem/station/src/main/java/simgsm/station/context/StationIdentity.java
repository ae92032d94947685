package simgsm.station.context;

import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.sim.SimCard;

/**
 * The identity of a station, from its SIM and its equipment.
 *
 * @param unitName the equipment's name in CCM, such as "SimGSM phone"
 * @param serviceCenter the SMSC's address on the SIM
 */
public record StationIdentity(Imsi imsi, Imei imei, Msisdn number, String unitName, Msisdn serviceCenter) {
    /** The service centre's number in the test network. */
    public static final Msisdn TEST_SERVICE_CENTER = new Msisdn("5550000");

    /** The identity of the subscriber on a SIM. */
    public static StationIdentity ofCard(SimCard card, Imei imei, String unitName) {
        return new StationIdentity(card.imsi(), imei, card.number(), unitName, TEST_SERVICE_CENTER);
    }

    /** The identity of a subscriber of an open network, which derives the IMSI from the number. */
    public static StationIdentity ofOpenNumber(Msisdn number, Imei imei, String unitName) {
        return new StationIdentity(Imsi.ofOpenNumber(number), imei, number, unitName, TEST_SERVICE_CENTER);
    }
}
