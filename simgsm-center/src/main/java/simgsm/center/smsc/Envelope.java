package simgsm.center.smsc;

import java.time.Instant;
import simgsm.air.Msisdn;
import simgsm.air.OctetString;

/** Something that waits in a receiver's queue. */
sealed interface Envelope {
    ShortMessage message();

    Msisdn receiver();

    Instant expiresAt();

    /** @param moreWaiting whether the receiver is told that more is to come (TP-MMS) */
    OctetString tpdu(boolean moreWaiting);

    /** A message on its way to its receiver. */
    record Delivery(ShortMessage message) implements Envelope {
        @Override
        public Msisdn receiver() {
            return message.to();
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
        public Msisdn receiver() {
            return message.from();
        }

        @Override
        public OctetString tpdu(boolean moreWaiting) {
            return TransferUnits.statusReport(message, state, at, moreWaiting);
        }
    }
}
