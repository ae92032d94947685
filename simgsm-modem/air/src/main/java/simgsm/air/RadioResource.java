package simgsm.air;

/** Radio resource messages (TS 44.018, 9.1), protocol discriminator 6; those that our one-cell network needs. */
public sealed interface RadioResource extends Layer3Message {
    private static void checkCause(int cause) {
        if (cause < 0 || cause > 0xff) {
            throw new IllegalArgumentException("RR cause " + cause + " is not 0 to 255");
        }
    }

    /** The mobile's answer to paging; opens a radio connection for a mobile-terminated call or message. */
    record PagingResponse(int keySequence, MobileIdentity identity) implements RadioResource {
        public PagingResponse {
            KeySequence.check(keySequence);
        }
    }

    /** @param cause RR cause (TS 44.018, 10.5.2.31); 0 is normal event */
    record ChannelRelease(int cause) implements RadioResource {
        public ChannelRelease {
            checkCause(cause);
        }
    }

    /** @param cause RR cause; 97 message type non-existent */
    record RrStatus(int cause) implements RadioResource {
        public RrStatus {
            checkCause(cause);
        }
    }
}
