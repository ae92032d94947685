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
        RadioResource message = readPlain(type, in);
        OptionalElements elements = new OptionalElements(in, FixedElements.NONE);
        while (elements.next() >= 0) {
            continue;
        }
        return message;
    }

    private static RadioResource readPlain(Layer3Type type, MessageReader in) throws ProtocolViolation {
        switch (type) {
            case PAGING_RESPONSE:
                int keySequence = in.octet("key sequence") & 0x07;
                in.lengthAndValue("classmark 2");
                return new PagingResponse(keySequence, IdentityElements.readIdentity(in));
            case CHANNEL_RELEASE:
                return new ChannelRelease(in.octet("RR cause"));
            default:
                return new RrStatus(in.octet("RR cause"));
        }
    }
}
