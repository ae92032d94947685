package simgsm.center.smsc;

import simgsm.sms.SmsAddress;

/**
 * What a message from an application (ESME) carries beyond that of a mobile.
 *
 * @param systemId whom receipts go to
 * @param source the address that the application gave itself; a number, or letters
 * @param dataCoding as submitted (SMPP 3.4, 5.2.19), so that another application is given the same octets
 * @param receipts which receipts are wanted
 */
public record EsmeOrigin(String systemId, SmsAddress source, int dataCoding, Receipts receipts) {
    /** The lowest two bits of registered_delivery (SMPP 3.4, 5.2.17); the code is the place in the list. */
    public enum Receipts {
        NONE,
        ALWAYS,
        ON_FAILURE;

        public boolean areWantedFor(MessageState state) {
            return this == ALWAYS || this == ON_FAILURE && state != MessageState.DELIVERED;
        }
    }
}
