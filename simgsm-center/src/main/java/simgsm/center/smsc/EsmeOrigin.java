package simgsm.center.smsc;

import java.time.Instant;
import java.util.Optional;
import simgsm.sms.SmsAddress;

/**
 * The properties of an application's (ESME's) message that a mobile's lacks.
 *
 * @param systemId receives the receipts
 * @param source originator address as submitted; a number, or letters
 * @param dataCoding as submitted (SMPP 3.4, 5.2.19); another application receives the same value
 * @param receipts requested receipts
 * @param group the message's position in its submission
 * @param deliverAt the first attempt (SMPP 3.4, 5.2.15); empty for an immediate one
 * @param serviceType as submitted (SMPP 3.4, 5.2.11); only messages of the same type replace each other
 */
public record EsmeOrigin(
        String systemId,
        SmsAddress source,
        int dataCoding,
        Receipts receipts,
        Group group,
        Optional<Instant> deliverAt,
        String serviceType) {
    /** Bits 1-0 of registered_delivery (SMPP 3.4, 5.2.17); the value is the ordinal. */
    public enum Receipts {
        NONE,
        ALWAYS,
        ON_FAILURE;

        public boolean areWantedFor(MessageState state) {
            return this == ALWAYS || this == ON_FAILURE && state != MessageState.DELIVERED;
        }
    }

    /**
     * The messages of one submission, its parts and destinations, have consecutive ids.
     *
     * @param before number of lower ids
     * @param after number of higher ids
     */
    public record Group(int before, int after) {
        public static final Group SINGLE = new Group(0, 0);
    }

    /** A single message, delivered at once. */
    public EsmeOrigin(String systemId, SmsAddress source, int dataCoding, Receipts receipts) {
        this(systemId, source, dataCoding, receipts, Group.SINGLE, Optional.empty(), "");
    }

    EsmeOrigin member(Group place, boolean isReceipted) {
        Receipts wanted = isReceipted ? receipts : Receipts.NONE;
        return new EsmeOrigin(systemId, source, dataCoding, wanted, place, deliverAt, serviceType);
    }

    /** The same origin with another request for receipts and time of delivery. */
    public EsmeOrigin with(Receipts newReceipts, Optional<Instant> newDeliverAt) {
        return new EsmeOrigin(systemId, source, dataCoding, newReceipts, group, newDeliverAt, serviceType);
    }
}
