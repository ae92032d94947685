package simgsm.air;

import simgsm.octets.Bounds;

/** Radio resource messages (TS 44.018, 9.1), protocol discriminator 6; those of a network with one cell. */
public sealed interface RadioResource extends Layer3Message {
    /** The mobile's answer to paging; opens a radio connection for a mobile-terminated call or message. */
    record PagingResponse(int keySequence, MobileIdentity identity) implements RadioResource {
        public PagingResponse {
            Bounds.check("ciphering key sequence number", keySequence, 0, MobilityManagement.NO_KEY);
        }
    }

    /** @param cause RR cause (TS 44.018, 10.5.2.31); 0 is normal event */
    record ChannelRelease(int cause) implements RadioResource {
        public ChannelRelease {
            Bounds.checkOctet("RR cause", cause);
        }
    }

    /** @param cause RR cause; 97 message type non-existent */
    record RrStatus(int cause) implements RadioResource {
        public RrStatus {
            Bounds.checkOctet("RR cause", cause);
        }
    }
}
