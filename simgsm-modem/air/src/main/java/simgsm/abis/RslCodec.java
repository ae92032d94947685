package simgsm.abis;

import simgsm.abis.RslMessage.BroadcastInformation;
import simgsm.abis.RslMessage.DataIndication;
import simgsm.abis.RslMessage.DataRequest;
import simgsm.abis.RslMessage.ErrorIndication;
import simgsm.abis.RslMessage.EstablishIndication;
import simgsm.abis.RslMessage.MeasurementResult;
import simgsm.abis.RslMessage.PagingCommand;
import simgsm.abis.RslMessage.ReleaseIndication;
import simgsm.abis.RslMessage.Sapi;
import simgsm.abis.RslMessage.SmsBroadcastCommand;
import simgsm.air.Cause;
import simgsm.air.Coded;
import simgsm.air.IdentityElements;
import simgsm.air.MessageReader;
import simgsm.air.MobileIdentity;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.OctetWriter;

/** RSL messages to the payload of an {@link IpaFrame#RSL} frame and back (TS 48.058, 8 and 9). */
public final class RslCodec {
    private static final int RADIO_LINK_LAYER = 0x02;
    private static final int DEDICATED_MANAGEMENT = 0x08;
    private static final int COMMON_CHANNEL = 0x0c;
    /** The lowest bit of the discriminator says whether the message is transparent to the base station. */
    private static final int DISCRIMINATOR_MASK = 0xfe;

    private static final int DATA_REQUEST = 0x01;
    private static final int DATA_INDICATION = 0x02;
    private static final int ERROR_INDICATION = 0x03;
    private static final int ESTABLISH_INDICATION = 0x06;
    private static final int RELEASE_INDICATION = 0x09;
    private static final int BROADCAST_INFORMATION = 0x11;
    private static final int PAGING_COMMAND = 0x15;
    private static final int SMS_BROADCAST_COMMAND = 0x1d;
    private static final int MEASUREMENT_RESULT = 0x28;

    private static final int CHANNEL_NUMBER = 0x01;
    private static final int LINK_IDENTIFIER = 0x02;
    private static final int BS_POWER = 0x04;
    private static final int LAYER_3_INFORMATION = 0x0b;
    private static final int MOBILE_IDENTITY = 0x0c;
    private static final int PAGING_GROUP = 0x0e;
    private static final int LINK_CAUSE = 0x16;
    private static final int UPLINK_MEASUREMENTS = 0x19;
    private static final int RESULT_NUMBER = 0x1b;
    private static final int SYSTEM_INFORMATION_TYPE = 0x1e;
    private static final int FULL_BCCH_INFORMATION = 0x27;
    private static final int CHANNEL_NEEDED = 0x28;
    private static final int BROADCAST_COMMAND_TYPE = 0x29;
    private static final int BROADCAST_MESSAGE = 0x2a;

    /** SDCCH/8 subchannel 0 in timeslot 1: the only dedicated channel of a terminal's cell. */
    private static final int DEDICATED_CHANNEL = 0x41;

    private static final int BROADCAST_CHANNEL = 0x80;
    private static final int PAGING_CHANNEL = 0x90;
    /** Uplink levels and qualities that are not known: all zero (TS 48.058, 9.3.25). */
    private static final int UPLINK_LENGTH = 3;

    private RslCodec() {}

    /** The payload of the message. */
    public static byte[] encode(RslMessage message) {
        if (message instanceof DataRequest data) {
            return layer3(DATA_REQUEST, data.sapi(), data.layer3());
        }
        if (message instanceof DataIndication data) {
            return layer3(DATA_INDICATION, data.sapi(), data.layer3());
        }
        if (message instanceof EstablishIndication establish) {
            return layer3(ESTABLISH_INDICATION, establish.sapi(), establish.layer3());
        }
        if (message instanceof ReleaseIndication release) {
            return radioLink(RELEASE_INDICATION, release.sapi()).toArray();
        }
        if (message instanceof ErrorIndication error) {
            OctetWriter out = radioLink(ERROR_INDICATION, error.sapi());
            return out.octet(LINK_CAUSE).octet(1).octet(error.cause()).toArray();
        }
        if (message instanceof PagingCommand paging) {
            return paging(paging.identity());
        }
        if (message instanceof BroadcastInformation information) {
            return information(information);
        }
        if (message instanceof MeasurementResult result) {
            return measurement(result);
        }
        return broadcast(((SmsBroadcastCommand) message).page());
    }

    /** The message of a payload. */
    public static RslMessage decode(byte[] payload) throws ProtocolViolation {
        MessageReader in = new MessageReader(payload);
        int discriminator = in.octet("RSL discriminator") & DISCRIMINATOR_MASK;
        int type = in.octet("RSL message type");
        expect(in, CHANNEL_NUMBER, "channel number");
        in.octet("channel number");
        if (discriminator == RADIO_LINK_LAYER) {
            return radioLink(type, in);
        }
        if (discriminator == COMMON_CHANNEL) {
            return commonChannel(type, in);
        }
        if (discriminator == DEDICATED_MANAGEMENT && type == MEASUREMENT_RESULT) {
            return measurement(in);
        }
        throw unknown(discriminator, type);
    }

    private static byte[] information(BroadcastInformation information) {
        return header(COMMON_CHANNEL, BROADCAST_INFORMATION, BROADCAST_CHANNEL)
                .octet(SYSTEM_INFORMATION_TYPE)
                .octet(information.type())
                .octet(FULL_BCCH_INFORMATION)
                .octet(information.block().length())
                .string(information.block())
                .toArray();
    }

    private static byte[] measurement(MeasurementResult result) {
        return header(DEDICATED_MANAGEMENT, MEASUREMENT_RESULT, DEDICATED_CHANNEL)
                .octet(RESULT_NUMBER)
                .octet(result.number())
                .octet(UPLINK_MEASUREMENTS)
                .octet(UPLINK_LENGTH)
                .bytes(new byte[UPLINK_LENGTH])
                .octet(BS_POWER)
                .octet(0)
                .octet(LAYER_3_INFORMATION)
                .twoOctets(result.report().length())
                .string(result.report())
                .toArray();
    }

    private static MeasurementResult measurement(MessageReader in) throws ProtocolViolation {
        expect(in, RESULT_NUMBER, "measurement result number");
        int number = in.octet("measurement result number");
        expect(in, UPLINK_MEASUREMENTS, "uplink measurements");
        in.lengthAndValue("uplink measurements");
        expect(in, BS_POWER, "BS power");
        in.octet("BS power");
        return new MeasurementResult(number, layer3(in));
    }

    private static byte[] layer3(int type, Sapi sapi, OctetString layer3) {
        OctetWriter out = radioLink(type, sapi);
        return out.octet(LAYER_3_INFORMATION)
                .twoOctets(layer3.length())
                .string(layer3)
                .toArray();
    }

    private static OctetWriter radioLink(int type, Sapi sapi) {
        return header(RADIO_LINK_LAYER, type, DEDICATED_CHANNEL)
                .octet(LINK_IDENTIFIER)
                .octet(sapi.code());
    }

    private static OctetWriter header(int discriminator, int type, int channel) {
        return new OctetWriter()
                .octet(discriminator)
                .octet(type)
                .octet(CHANNEL_NUMBER)
                .octet(channel);
    }

    private static byte[] paging(MobileIdentity identity) {
        OctetWriter out = header(COMMON_CHANNEL, PAGING_COMMAND, PAGING_CHANNEL);
        out.octet(PAGING_GROUP).octet(0).octet(MOBILE_IDENTITY);
        int start = out.openLength();
        IdentityElements.write(out, identity);
        out.closeLength(start);
        return out.octet(CHANNEL_NEEDED).octet(0).toArray();
    }

    private static byte[] broadcast(OctetString page) {
        OctetWriter out = header(COMMON_CHANNEL, SMS_BROADCAST_COMMAND, PAGING_CHANNEL);
        out.octet(BROADCAST_COMMAND_TYPE).octet(0);
        return out.octet(BROADCAST_MESSAGE).octet(page.length()).string(page).toArray();
    }

    private static RslMessage radioLink(int type, MessageReader in) throws ProtocolViolation {
        expect(in, LINK_IDENTIFIER, "link identifier");
        Sapi sapi = sapi(in.octet("link identifier"));
        return switch (type) {
            case DATA_REQUEST -> new DataRequest(sapi, layer3(in));
            case DATA_INDICATION -> new DataIndication(sapi, layer3(in));
            case ESTABLISH_INDICATION -> new EstablishIndication(sapi, layer3(in));
            case RELEASE_INDICATION -> new ReleaseIndication(sapi);
            case ERROR_INDICATION -> errorIndication(sapi, in);
            default -> throw unknown(RADIO_LINK_LAYER, type);
        };
    }

    private static ErrorIndication errorIndication(Sapi sapi, MessageReader in) throws ProtocolViolation {
        expect(in, LINK_CAUSE, "link layer cause");
        MessageReader cause = in.lengthAndValue("link layer cause");
        return new ErrorIndication(sapi, cause.octet("link layer cause") & 0x7f);
    }

    private static RslMessage commonChannel(int type, MessageReader in) throws ProtocolViolation {
        if (type == PAGING_COMMAND) {
            expect(in, PAGING_GROUP, "paging group");
            in.octet("paging group");
            expect(in, MOBILE_IDENTITY, "mobile identity");
            return new PagingCommand(IdentityElements.read(in.lengthAndValue("mobile identity")));
        }
        if (type == BROADCAST_INFORMATION) {
            expect(in, SYSTEM_INFORMATION_TYPE, "system information type");
            int kind = in.octet("system information type");
            expect(in, FULL_BCCH_INFORMATION, "full BCCH information");
            MessageReader block = in.lengthAndValue("full BCCH information");
            return new BroadcastInformation(kind, block.string(BroadcastInformation.BLOCK_LENGTH, "BCCH block"));
        }
        if (type == SMS_BROADCAST_COMMAND) {
            expect(in, BROADCAST_COMMAND_TYPE, "broadcast command type");
            in.octet("broadcast command type");
            expect(in, BROADCAST_MESSAGE, "broadcast message");
            MessageReader page = in.lengthAndValue("broadcast message");
            return new SmsBroadcastCommand(page.string(SmsBroadcastCommand.PAGE_LENGTH, "cell broadcast page"));
        }
        throw unknown(COMMON_CHANNEL, type);
    }

    /** The layer-3 message, which must end with the payload. */
    private static OctetString layer3(MessageReader in) throws ProtocolViolation {
        expect(in, LAYER_3_INFORMATION, "layer 3 information");
        int length = in.twoOctets("layer 3 length");
        if (length != in.remaining()) {
            throw ProtocolViolation.invalid("layer 3 length " + length + ", " + in.remaining() + " octets are left");
        }
        return in.rest();
    }

    /** Bit 7, the slow associated channel, is ignored. */
    private static Sapi sapi(int link) throws ProtocolViolation {
        return Coded.find(Sapi.values(), link & ~0x40)
                .orElseThrow(() -> ProtocolViolation.invalid("link identifier " + link + " is not SAPI 0 or 3"));
    }

    private static void expect(MessageReader in, int element, String what) throws ProtocolViolation {
        int found = in.octet(what);
        if (found != element) {
            throw ProtocolViolation.invalid(
                    String.format("RSL element 0x%02x where %s (0x%02x) was expected", found, what, element));
        }
    }

    private static ProtocolViolation unknown(int discriminator, int type) {
        return new ProtocolViolation(
                Cause.MESSAGE_TYPE_NON_EXISTENT,
                String.format("RSL message type 0x%02x of discriminator 0x%02x", type, discriminator));
    }
}
