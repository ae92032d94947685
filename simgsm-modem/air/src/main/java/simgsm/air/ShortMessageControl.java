package simgsm.air;

/** The CP layer of short messages (TS 24.011, 7.2), protocol discriminator 9, on SAPI 3. */
public sealed interface ShortMessageControl extends Layer3Message.OfTransaction {
    record CpData(TransactionIdentifier transaction, RelayMessage relay) implements ShortMessageControl {}

    record CpAck(TransactionIdentifier transaction) implements ShortMessageControl {}

    /** @param cause CP cause (TS 24.011, 8.1.4.2): 17 network failure, 22 congestion, 81 invalid transaction identifier,
     *     95 semantically incorrect, 96 invalid mandatory information, 97 message type non-existent, 98 not compatible
     *     with the protocol state, 111 protocol error */
    record CpError(TransactionIdentifier transaction, int cause) implements ShortMessageControl {}
}
