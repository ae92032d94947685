package simgsm.air;

/**
 * The transaction identifier of call control and short-message messages (TS 24.007, 11.2.3.1.3).
 *
 * @param value the transaction's number at the side that opened it, 0 to 6
 * @param fromOtherSide the TI flag: false in messages from the side that opened the transaction, true in the answers
 */
public record TransactionIdentifier(int value, boolean fromOtherSide) {
    public TransactionIdentifier {
        if (value < 0 || value > 6) {
            throw new IllegalArgumentException("transaction identifier " + value + " is not 0 to 6");
        }
    }

    /** The identifier that the receiver of a message writes into its answers. */
    public TransactionIdentifier answered() {
        return new TransactionIdentifier(value, !fromOtherSide);
    }
}
