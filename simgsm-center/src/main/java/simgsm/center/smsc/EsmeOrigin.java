package simgsm.center.smsc;

import simgsm.sms.SmsAddress;

/**
 * What a message from an application (ESME) has in addition to a mobile's.
 *
 * @param systemId receives the receipts
 * @param source originator address as submitted; a number, or letters
 * @param dataCoding as submitted (SMPP 3.4, 5.2.19); another application receives the same value
 * @param receipts which receipts are requested
 */
public record EsmeOrigin(String systemId, SmsAddress source, int dataCoding, Receipts receipts) {
    /** Bits 1-0 of registered_delivery (SMPP 3.4, 5.2.17); the value is the ordinal. */
    public enum Receipts {
        NONE,
        ALWAYS,
        ON_FAILURE;

        public boolean areWantedFor(MessageState state) {
            return this == ALWAYS || this == ON_FAILURE && state != MessageState.DELIVERED;
        }
    }

    EsmeOrigin withoutReceipts() {
        return new EsmeOrigin(systemId, source, dataCoding, Receipts.NONE);
    }
}
