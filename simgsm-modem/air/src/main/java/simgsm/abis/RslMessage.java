package simgsm.abis;

import static simgsm.abis.RslElement.BROADCAST_COMMAND_TYPE;
import static simgsm.abis.RslElement.BROADCAST_MESSAGE;
import static simgsm.abis.RslElement.BS_POWER;
import static simgsm.abis.RslElement.CHANNEL_NEEDED;
import static simgsm.abis.RslElement.ENCRYPTION_INFORMATION;
import static simgsm.abis.RslElement.FULL_BCCH_INFORMATION;
import static simgsm.abis.RslElement.L3_INFORMATION;
import static simgsm.abis.RslElement.LINK_CAUSE;
import static simgsm.abis.RslElement.LINK_IDENTIFIER;
import static simgsm.abis.RslElement.MEASUREMENT_RESULT_NUMBER;
import static simgsm.abis.RslElement.MOBILE_IDENTITY;
import static simgsm.abis.RslElement.PAGING_GROUP;
import static simgsm.abis.RslElement.SYSTEM_INFORMATION_TYPE;
import static simgsm.abis.RslElement.UPLINK_MEASUREMENTS;

import simgsm.air.Cause;
import simgsm.air.ChannelNumber;
import simgsm.air.Coded;
import simgsm.air.IdentityElements;
import simgsm.air.MobileIdentity;
import simgsm.air.ProtocolViolation;
import simgsm.octets.Bounds;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/**
 * The content of the {@link RslPdu}s exchanged by a terminal with its own cell. Layer 3 is kept as octets, so relays
 * and traces do not depend on it.
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
    record EstablishIndication(Sapi sapi, OctetString layer3) implements RslMessage {
        @Override
        public RslPdu pdu() {
            return radioLink(RslType.ESTABLISH_INDICATION, sapi).with(L3_INFORMATION, layer3);
        }
    }

    /** Up: a further layer-3 message. */
    record DataIndication(Sapi sapi, OctetString layer3) implements RslMessage {
        @Override
        public RslPdu pdu() {
            return radioLink(RslType.DATA_INDICATION, sapi).with(L3_INFORMATION, layer3);
        }
    }

    /** Down: a layer-3 message. */
    record DataRequest(Sapi sapi, OctetString layer3) implements RslMessage {
        @Override
        public RslPdu pdu() {
            return radioLink(RslType.DATA_REQUEST, sapi).with(L3_INFORMATION, layer3);
        }
    }

    /** Up: the mobile has left the channel. */
    record ReleaseIndication(Sapi sapi) implements RslMessage {
        @Override
        public RslPdu pdu() {
            return radioLink(RslType.RELEASE_INDICATION, sapi);
        }
    }

    /** Up: an error of the link layer. @param cause TS 48.058, 9.3.26 */
    record ErrorIndication(Sapi sapi, int cause) implements RslMessage {
        public ErrorIndication {
            Bounds.check("link layer cause", cause, 0, 0x7f);
        }

        @Override
        public RslPdu pdu() {
            return radioLink(RslType.ERROR_INDICATION, sapi).with(LINK_CAUSE, cause);
        }
    }

    /**
     * Up, to a cells program, which ciphers the air for the terminal: the key of its card. Between controller and base
     * station this message is downlink (TS 48.058, 8.4.6).
     *
     * @param information algorithm and key (9.3.7)
     * @param command the CIPHERING MODE COMMAND that the terminal follows
     */
    record EncryptionCommand(OctetString information, OctetString command) implements RslMessage {
        @Override
        public RslPdu pdu() {
            return RslPdu.of(RslType.ENCRYPTION_COMMAND, DEDICATED_CHANNEL)
                    .with(ENCRYPTION_INFORMATION, information)
                    .with(LINK_IDENTIFIER, Sapi.SIGNALLING.code())
                    .with(L3_INFORMATION, command);
        }
    }

    /** Down: pages this mobile. */
    record PagingCommand(MobileIdentity identity) implements RslMessage {
        @Override
        public RslPdu pdu() {
            OctetWriter value = new OctetWriter();
            IdentityElements.write(value, identity);
            return RslPdu.of(RslType.PAGING_COMMAND, PAGING_CHANNEL)
                    .with(PAGING_GROUP, 0)
                    .with(MOBILE_IDENTITY, value.toOctetString())
                    .with(CHANNEL_NEEDED, 0);
        }
    }

    /**
     * Down, from a cells program: SYSTEM INFORMATION of the serving cell (TS 48.058, 8.5.1).
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

        @Override
        public RslPdu pdu() {
            return RslPdu.of(RslType.BCCH_INFORMATION, BROADCAST_CHANNEL)
                    .with(SYSTEM_INFORMATION_TYPE, type)
                    .with(FULL_BCCH_INFORMATION, block);
        }
    }

    /**
     * Down, from a cells program, which measures for the terminal: a MEASUREMENT REPORT (TS 48.058, 8.4.8). Between
     * base station and controller this message is uplink.
     *
     * @param number counts the reports, 0 to 255
     */
    record MeasurementResult(int number, OctetString report) implements RslMessage {
        public MeasurementResult {
            Bounds.checkOctet("measurement result number", number);
        }

        /** Uplink levels and qualities are unknown and sent as zero (TS 48.058, 9.3.25). */
        @Override
        public RslPdu pdu() {
            return RslPdu.of(RslType.MEASUREMENT_RESULT, DEDICATED_CHANNEL)
                    .with(MEASUREMENT_RESULT_NUMBER, number)
                    .with(UPLINK_MEASUREMENTS, 0, 0, 0)
                    .with(BS_POWER, 0)
                    .with(L3_INFORMATION, report);
        }
    }

    /** Down: one whole cell broadcast page of 88 octets (TS 23.041). */
    record SmsBroadcastCommand(OctetString page) implements RslMessage {
        public static final int PAGE_LENGTH = 88;

        public SmsBroadcastCommand {
            page.requireLength("cell broadcast page", PAGE_LENGTH);
        }

        @Override
        public RslPdu pdu() {
            return RslPdu.of(RslType.SMS_BROADCAST_COMMAND, PAGING_CHANNEL)
                    .with(BROADCAST_COMMAND_TYPE, 0)
                    .with(BROADCAST_MESSAGE, page);
        }
    }

    /** Subchannel 0 in timeslot 1: the only dedicated channel of a terminal's cell. */
    ChannelNumber DEDICATED_CHANNEL = ChannelNumber.of(ChannelNumber.Kind.SDCCH_8, 1);

    ChannelNumber BROADCAST_CHANNEL = ChannelNumber.of(ChannelNumber.Kind.BCCH, 0);
    ChannelNumber PAGING_CHANNEL = ChannelNumber.of(ChannelNumber.Kind.PCH_AGCH, 0);

    /** The message with its elements. */
    RslPdu pdu();

    /** The payload of an {@link IpaFrame#RSL} frame. */
    default byte[] encode() {
        return pdu().encode();
    }

    /** The message of a payload. @throws ProtocolViolation also for types never used by terminals */
    static RslMessage decode(byte[] payload) throws ProtocolViolation {
        RslPdu pdu = RslPdu.decode(payload);
        pdu.octet(RslElement.CHANNEL_NUMBER);
        return switch (pdu.type()) {
            case ESTABLISH_INDICATION -> new EstablishIndication(sapi(pdu), pdu.value(L3_INFORMATION));
            case DATA_INDICATION -> new DataIndication(sapi(pdu), pdu.value(L3_INFORMATION));
            case DATA_REQUEST -> new DataRequest(sapi(pdu), pdu.value(L3_INFORMATION));
            case RELEASE_INDICATION -> new ReleaseIndication(sapi(pdu));
            case ERROR_INDICATION -> new ErrorIndication(sapi(pdu), pdu.octet(LINK_CAUSE) & 0x7f);
            case ENCRYPTION_COMMAND ->
                new EncryptionCommand(pdu.value(ENCRYPTION_INFORMATION), pdu.value(L3_INFORMATION));
            case PAGING_COMMAND -> new PagingCommand(IdentityElements.read(pdu.reader(MOBILE_IDENTITY)));
            case BCCH_INFORMATION ->
                new BroadcastInformation(
                        pdu.octet(SYSTEM_INFORMATION_TYPE),
                        pdu.reader(FULL_BCCH_INFORMATION)
                                .string(BroadcastInformation.BLOCK_LENGTH, FULL_BCCH_INFORMATION.toString()));
            case MEASUREMENT_RESULT ->
                new MeasurementResult(pdu.octet(MEASUREMENT_RESULT_NUMBER), pdu.value(L3_INFORMATION));
            case SMS_BROADCAST_COMMAND ->
                new SmsBroadcastCommand(pdu.reader(BROADCAST_MESSAGE)
                        .string(SmsBroadcastCommand.PAGE_LENGTH, BROADCAST_MESSAGE.toString()));
            default ->
                throw new ProtocolViolation(
                        Cause.MESSAGE_TYPE_NON_EXISTENT, "RSL " + pdu.type().title() + " on a terminal's link");
        };
    }

    private static RslPdu radioLink(RslType type, Sapi sapi) {
        return RslPdu.of(type, DEDICATED_CHANNEL, sapi.code());
    }

    /** Bit 7, the slow associated channel, is ignored. */
    private static Sapi sapi(RslPdu pdu) throws ProtocolViolation {
        int link = pdu.octet(LINK_IDENTIFIER);
        return Coded.find(Sapi.values(), link & ~0x40)
                .orElseThrow(() -> ProtocolViolation.invalid("link identifier " + link + " is not SAPI 0 or 3"));
    }
}
