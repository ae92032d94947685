package simgsm.air;

import simgsm.air.OptionalElements.FixedElements;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.RadioResource.RrStatus;
import simgsm.octets.OctetWriter;

/** What follows the message type in radio resource messages (TS 44.018, 9.1). */
final class RadioResourceCodec {
    private RadioResourceCodec() {}

    static void write(OctetWriter out, RadioResource message) {
        if (message instanceof PagingResponse response) {
            out.octet(response.keySequence()).string(MobilityManagementCodec.CLASSMARK_2);
            IdentityElements.writeIdentity(out, response.identity());
        } else if (message instanceof ChannelRelease release) {
            out.octet(release.cause());
        } else if (message instanceof RrStatus status) {
            out.octet(status.cause());
        }
    }

    static RadioResource read(Layer3Type type, MessageReader in) throws ProtocolViolation {
        RadioResource message = switch (type) {
            case PAGING_RESPONSE -> readPagingResponse(in);
            case CHANNEL_RELEASE -> new ChannelRelease(in.octet("RR cause"));
            default -> new RrStatus(in.octet("RR cause"));
        };
        new OptionalElements(in, FixedElements.NONE).skipAll();
        return message;
    }

    private static PagingResponse readPagingResponse(MessageReader in) throws ProtocolViolation {
        int keySequence = in.octet("key sequence") & 0x07;
        in.lengthAndValue("classmark 2");
        return new PagingResponse(keySequence, IdentityElements.readIdentity(in));
    }
}
