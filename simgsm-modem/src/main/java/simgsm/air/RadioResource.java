package simgsm.air;

/** Radio resource messages (TS 44.018, 9.1), protocol discriminator 6; those that our one-cell network needs. */
public sealed interface RadioResource extends Layer3Message {

    /** The mobile's answer to paging; opens a radio connection for a mobile-terminated call or message. */
    record PagingResponse(int keySequence, MobileIdentity identity) implements RadioResource {}

    /** @param cause RR cause (TS 44.018, 10.5.2.31); 0 is normal event */
    record ChannelRelease(int cause) implements RadioResource {}

    /** @param cause RR cause; 97 message type non-existent */
    record RrStatus(int cause) implements RadioResource {}
}
