package simgsm.station;

import simgsm.air.Imei;
import simgsm.air.Imsi;
import simgsm.air.Msisdn;
import simgsm.sim.SimCard;

/**
 * Who a station is: what its SIM and its equipment say.
 *
 * @param unitName what the equipment calls itself to the network, as "SimGSM phone"
 * @param serviceCenter the SMSC's address as the SIM stores it
 */
public record StationIdentity(Imsi imsi, Imei imei, Msisdn number, String unitName, Msisdn serviceCenter) {
    /** The service centre's number in the test network. */
    public static final Msisdn TEST_SERVICE_CENTER = new Msisdn("5550000");

    /** The subscriber whose card is in the slot. */
    public static StationIdentity ofCard(SimCard card, Imei imei, String unitName) {
        return new StationIdentity(card.imsi(), imei, card.number(), unitName, TEST_SERVICE_CENTER);
    }

    /** A subscriber of an open network, where the number gives the IMSI. */
    public static StationIdentity ofOpenNumber(Msisdn number, Imei imei, String unitName) {
        return new StationIdentity(Imsi.ofOpenNumber(number), imei, number, unitName, TEST_SERVICE_CENTER);
    }
}
