package simgsm.air;

import java.util.Optional;
import simgsm.octets.OctetString;

/**
 * Supplementary service control (TS 24.080, 2), protocol discriminator 11. The component in a facility element is read by
 * {@code simgsm.ss}.
 */
public sealed interface SupplementaryService extends Layer3Message.OfTransaction {
    /**
     * Begins a dialogue.
     *
     * @param version SS version indicator (TS 24.008, 10.5.4.24), sent by mobiles of phase 2 or later
     */
    record SsRegister(TransactionIdentifier transaction, OctetString facility, Optional<Integer> version)
            implements SupplementaryService {
        /** Phase 2 with its error handling. */
        public static final int PHASE_2 = 0;
    }

    /** Continues a dialogue. */
    record SsFacility(TransactionIdentifier transaction, OctetString facility) implements SupplementaryService {}

    /** Ends a dialogue, with its last component, the cause of its failure, or neither. */
    record SsReleaseComplete(TransactionIdentifier transaction, Optional<Cause> cause, Optional<OctetString> facility)
            implements SupplementaryService {
        /** The end of a dialogue without further content. */
        public SsReleaseComplete(TransactionIdentifier transaction) {
            this(transaction, Optional.empty(), Optional.empty());
        }

        /** The end of a dialogue with its last component. */
        public SsReleaseComplete(TransactionIdentifier transaction, OctetString facility) {
            this(transaction, Optional.empty(), Optional.of(facility));
        }

        /** The end of a dialogue by a failure. */
        public SsReleaseComplete(TransactionIdentifier transaction, Cause cause) {
            this(transaction, Optional.of(cause), Optional.empty());
        }
    }
}
