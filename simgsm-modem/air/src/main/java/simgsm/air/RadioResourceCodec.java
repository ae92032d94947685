package simgsm.air;

import java.util.Optional;
import simgsm.air.OptionalElements.FixedElements;
import simgsm.air.RadioResource.*;
import simgsm.octets.OctetWriter;

/** What follows the message type in radio resource messages (TS 44.018, 9.1). */
final class RadioResourceCodec {
    private static final int POWER_MASK = 0x1f;
    private static final int CHANNEL_MODE = 0x63;

    private RadioResourceCodec() {}

    static void write(OctetWriter out, RadioResource message) {
        if (message instanceof PagingResponse response) {
            out.octet(response.keySequence()).string(MobilityManagementCodec.CLASSMARK_2);
            IdentityElements.writeIdentity(out, response.identity());
        } else if (message instanceof ChannelRelease release) {
            out.octet(release.cause());
        } else if (message instanceof RrStatus status) {
            out.octet(status.cause());
        } else if (message instanceof AssignmentCommand command) {
            out.string(command.channel().encode()).octet(command.powerLevel());
            out.octet(CHANNEL_MODE).octet(command.channelMode());
        } else if (message instanceof ChannelModeModify modify) {
            out.string(modify.channel().encode()).octet(modify.mode());
        } else if (message instanceof ChannelModeModifyAcknowledge acknowledge) {
            out.string(acknowledge.channel().encode()).octet(acknowledge.mode());
        } else if (message instanceof AssignmentComplete complete) {
            out.octet(complete.cause());
        } else if (message instanceof AssignmentFailure failure) {
            out.octet(failure.cause());
        } else if (message instanceof HandoverCommand command) {
            out.string(command.cell().encode()).string(command.channel().encode());
            out.octet(command.reference()).octet(command.powerLevel());
            command.channelMode().ifPresent(mode -> out.octet(CHANNEL_MODE).octet(mode));
        } else if (message instanceof HandoverComplete complete) {
            out.octet(complete.cause());
        } else if (message instanceof HandoverFailure failure) {
            out.octet(failure.cause());
        } else if (message instanceof PhysicalInformation information) {
            out.octet(information.timingAdvance());
        } else if (message instanceof MeasurementReport report) {
            out.bytes(report.results().value());
        }
    }

    static RadioResource read(Layer3Type type, MessageReader in) throws ProtocolViolation {
        return switch (type) {
            case ASSIGNMENT_COMMAND -> readAssignment(in);
            case HANDOVER_COMMAND -> readHandover(in);
            default -> readFixed(type, in);
        };
    }

    private static RadioResource readFixed(Layer3Type type, MessageReader in) throws ProtocolViolation {
        RadioResource message = switch (type) {
            case CHANNEL_MODE_MODIFY -> new ChannelModeModify(ChannelDescription.read(in), in.octet("channel mode"));
            case CHANNEL_MODE_MODIFY_ACKNOWLEDGE ->
                new ChannelModeModifyAcknowledge(ChannelDescription.read(in), in.octet("channel mode"));
            case ASSIGNMENT_COMPLETE -> new AssignmentComplete(in.octet("RR cause"));
            case ASSIGNMENT_FAILURE -> new AssignmentFailure(in.octet("RR cause"));
            case HANDOVER_COMPLETE -> new HandoverComplete(in.octet("RR cause"));
            case HANDOVER_FAILURE -> new HandoverFailure(in.octet("RR cause"));
            case PHYSICAL_INFORMATION -> new PhysicalInformation(in.octet("timing advance") & 0x3f);
            case MEASUREMENT_REPORT -> new MeasurementReport(MeasurementResults.read(in));
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

    private static AssignmentCommand readAssignment(MessageReader in) throws ProtocolViolation {
        ChannelDescription channel = ChannelDescription.read(in);
        int power = in.octet("power command") & POWER_MASK;
        return new AssignmentCommand(channel, power, channelMode(in).orElse(RadioResource.SPEECH_FULL_RATE));
    }

    private static HandoverCommand readHandover(MessageReader in) throws ProtocolViolation {
        CellDescription cell = CellDescription.read(in);
        ChannelDescription channel = ChannelDescription.read(in);
        int reference = in.octet("handover reference");
        int power = in.octet("power command") & POWER_MASK;
        return new HandoverCommand(cell, channel, reference, power, channelMode(in));
    }

    private static Optional<Integer> channelMode(MessageReader in) throws ProtocolViolation {
        Optional<MessageReader> mode = new OptionalElements(in, FixedElements.RADIO_RESOURCE).first(CHANNEL_MODE);
        return mode.isPresent() ? Optional.of(mode.get().octet("channel mode")) : Optional.empty();
    }
}
