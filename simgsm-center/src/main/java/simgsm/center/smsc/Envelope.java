package simgsm.center.smsc;

import java.time.Instant;
import java.util.Optional;
import java.util.function.UnaryOperator;
import simgsm.air.Msisdn;
import simgsm.octets.OctetString;

/** An element of a receiver's queue: a message, or a report on one. */
public sealed interface Envelope {
    ShortMessage message();

    Destination destination();

    Instant expiresAt();

    /** The time of the first attempt; empty for an immediate one. */
    default Optional<Instant> notBefore() {
        return Optional.empty();
    }

    /**
     * The DELIVER or STATUS-REPORT.
     *
     * @param moreWaiting true if further messages wait for the destination (TP-MMS)
     * @param shown a subscriber's number as others see it
     */
    OctetString tpdu(boolean moreWaiting, UnaryOperator<Msisdn> shown);

    /** The same with numbers as they are in the registers. */
    default OctetString tpdu(boolean moreWaiting) {
        return tpdu(moreWaiting, UnaryOperator.identity());
    }

    /** A message for its receiver. */
    record Delivery(ShortMessage message) implements Envelope {
        @Override
        public Destination destination() {
            return new Destination.Number(message.to());
        }

        @Override
        public Instant expiresAt() {
            return message.expiresAt();
        }

        @Override
        public Optional<Instant> notBefore() {
            return message.esme().flatMap(EsmeOrigin::deliverAt);
        }

        @Override
        public OctetString tpdu(boolean moreWaiting, UnaryOperator<Msisdn> shown) {
            return TransferUnits.deliver(message, moreWaiting, shown);
        }
    }

    /** The final state of a message, for its sender. */
    record Report(ShortMessage message, MessageState state, Instant at, Instant expiresAt) implements Envelope {
        @Override
        public Destination destination() {
            return message.esme()
                    .<Destination>map(origin -> new Destination.Esme(origin.systemId()))
                    .orElseGet(() -> new Destination.Number(message.from()));
        }

        @Override
        public OctetString tpdu(boolean moreWaiting, UnaryOperator<Msisdn> shown) {
            return TransferUnits.statusReport(message, state, at, moreWaiting);
        }
    }
}
