package simgsm.center.smsc;

import java.time.Instant;
import simgsm.octets.OctetString;

/** Something that waits in a receiver's queue. */
public sealed interface Envelope {
    ShortMessage message();

    Recipient receiver();

    Instant expiresAt();

    /**
     * DELIVER or STATUS-REPORT.
     *
     * @param moreWaiting whether the receiver is told that more is to come (TP-MMS)
     */
    OctetString tpdu(boolean moreWaiting);

    /** A message on its way to its receiver. */
    record Delivery(ShortMessage message) implements Envelope {
        @Override
        public Recipient receiver() {
            return new Recipient.Number(message.to());
        }

        @Override
        public Instant expiresAt() {
            return message.expiresAt();
        }

        @Override
        public OctetString tpdu(boolean moreWaiting) {
            return TransferUnits.deliver(message, moreWaiting);
        }
    }

    /** What became of a message, on its way back to the sender. */
    record Report(ShortMessage message, MessageState state, Instant at, Instant expiresAt) implements Envelope {
        @Override
        public Recipient receiver() {
            return message.esme()
                    .<Recipient>map(origin -> new Recipient.Esme(origin.systemId()))
                    .orElseGet(() -> new Recipient.Number(message.from()));
        }

        @Override
        public OctetString tpdu(boolean moreWaiting) {
            return TransferUnits.statusReport(message, state, at, moreWaiting);
        }
    }
}
