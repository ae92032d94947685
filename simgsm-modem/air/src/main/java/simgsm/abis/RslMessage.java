package simgsm.abis;

import simgsm.air.Coded;
import simgsm.air.MobileIdentity;
import simgsm.octets.Bounds;
import simgsm.octets.OctetString;

/**
 * Radio signalling link messages (TS 48.058, 8) of a terminal that carries its own cell. Layer 3 is kept as octets, so
 * that relays and traces do not depend on it.
 */
public sealed interface RslMessage {
    /** Service access point identifier of a radio link (TS 44.005). */
    enum Sapi implements Coded {
        /** Radio resource, mobility management, call control. */
        SIGNALLING(0),
        /** Short messages. */
        SHORT_MESSAGES(3);

        private final int code;

        Sapi(int code) {
            this.code = code;
        }

        @Override
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
            Bounds.check("link layer cause", cause, 0, 0x7f);
        }
    }

    /** Down: pages this mobile. */
    record PagingCommand(MobileIdentity identity) implements RslMessage {}

    /**
     * Down, from a cells program: SYSTEM INFORMATION of the cell on which the mobile is (TS 48.058, 8.5.1).
     *
     * @param block the whole BCCH block of 23 octets
     */
    record BroadcastInformation(int type, OctetString block) implements RslMessage {
        /** SYSTEM INFORMATION TYPE 3 (9.3.30). */
        public static final int TYPE_3 = 3;

        public static final int BLOCK_LENGTH = 23;

        public BroadcastInformation {
            Bounds.checkOctet("system information type", type);
            block.requireLength("BCCH block", BLOCK_LENGTH);
        }
    }

    /**
     * Down, from a cells program, which measures in the terminal's place: a MEASUREMENT REPORT (TS 48.058, 8.4.8). Between
     * base station and controller this message goes up.
     *
     * @param number counts the reports, 0 to 255
     */
    record MeasurementResult(int number, OctetString report) implements RslMessage {
        public MeasurementResult {
            Bounds.checkOctet("measurement result number", number);
        }
    }

    /** Down: one whole cell broadcast page of 88 octets (TS 23.041). */
    record SmsBroadcastCommand(OctetString page) implements RslMessage {
        public static final int PAGE_LENGTH = 88;

        public SmsBroadcastCommand {
            page.requireLength("cell broadcast page", PAGE_LENGTH);
        }
    }
}
