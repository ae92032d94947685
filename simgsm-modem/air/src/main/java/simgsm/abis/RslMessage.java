package simgsm.abis;

import simgsm.air.MobileIdentity;
import simgsm.octets.OctetString;

/**
 * Radio signalling link messages (TS 48.058, 8) as far as a terminal with a small cell of its own needs them. Layer 3
 * travels as raw octets so that a relay or a trace need not understand it.
 */
public sealed interface RslMessage {
    /** Service access point of a radio link: which conversation on the channel (TS 44.005). */
    enum Sapi {
        /** Radio resource, mobility management, call control. */
        SIGNALLING(0),
        /** Short messages. */
        SHORT_MESSAGES(3);

        private final int code;

        Sapi(int code) {
            this.code = code;
        }

        public int code() {
            return code;
        }
    }

    /** Up: the first layer-3 message of a new radio connection. */
    record EstablishIndication(Sapi sapi, OctetString layer3) implements RslMessage {}

    /** Up: a further layer-3 message. */
    record DataIndication(Sapi sapi, OctetString layer3) implements RslMessage {}

    /** Down: a layer-3 message. */
    record DataRequest(Sapi sapi, OctetString layer3) implements RslMessage {}

    /** Up: the mobile has left the channel. */
    record ReleaseIndication(Sapi sapi) implements RslMessage {}

    /** Up: the link layer refused something. @param cause TS 48.058, 9.3.26 */
    record ErrorIndication(Sapi sapi, int cause) implements RslMessage {
        public ErrorIndication {
            if (cause < 0 || cause > 0x7f) {
                throw new IllegalArgumentException("link layer cause " + cause + " is not 0 to 127");
            }
        }
    }

    /** Down: look for this mobile. */
    record PagingCommand(MobileIdentity identity) implements RslMessage {}

    /** Down: one whole cell broadcast page of 88 octets (TS 23.041). */
    record SmsBroadcastCommand(OctetString page) implements RslMessage {
        public static final int PAGE_LENGTH = 88;

        public SmsBroadcastCommand {
            if (page.length() != PAGE_LENGTH) {
                throw new IllegalArgumentException(
                        "a cell broadcast page of " + page.length() + " octets, " + PAGE_LENGTH + " were expected");
            }
        }
    }
}
