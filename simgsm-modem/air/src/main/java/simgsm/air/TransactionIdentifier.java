package simgsm.air;

import simgsm.octets.Bounds;

/**
 * The transaction identifier of call control, short-message and supplementary service messages (TS 24.007, 11.2.3.1.3).
 *
 * @param value the transaction's number at the side that opened it, 0 to 6
 * @param fromOtherSide the TI flag: false in messages from the side that opened the transaction, true in the answers
 */
public record TransactionIdentifier(int value, boolean fromOtherSide) {
    public TransactionIdentifier {
        Bounds.check("transaction identifier", value, 0, 6);
    }

    /** The same transaction with the other TI flag, for the receiver's answers. */
    public TransactionIdentifier answered() {
        return new TransactionIdentifier(value, !fromOtherSide);
    }
}
