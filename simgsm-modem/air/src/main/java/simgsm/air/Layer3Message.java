package simgsm.air;

/**
 * A layer-3 message between a mobile and the network, by protocol discriminator (TS 24.007, 11.2.3.1.1). Its elements are in
 * {@link Layer3Type}.
 */
public sealed interface Layer3Message permits MobilityManagement, RadioResource, Layer3Message.OfTransaction {
    /** A message of call control, short messages or supplementary services, which have transactions. */
    sealed interface OfTransaction extends Layer3Message
            permits CallControl, ShortMessageControl, SupplementaryService {
        TransactionIdentifier transaction();
    }
}
