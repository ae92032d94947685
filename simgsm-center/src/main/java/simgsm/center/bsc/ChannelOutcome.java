package simgsm.center.bsc;

import java.util.Optional;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Type;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.center.bsc.ConnectionTable.ConnectionEvent;
import simgsm.octets.OctetString;

/**
 * A mobile's message that ends an assignment, a handover or a change of the channel's mode.
 *
 * @param title of the message
 */
record ChannelOutcome(String title, ConnectionEvent event) {
    /** The outcome in a layer 3 message; empty for any other message or an invalid one. */
    static Optional<ChannelOutcome> of(OctetString layer3) {
        if (layer3.length() < 2 || layer3.octet(0) != Layer3Header.RADIO_RESOURCE) {
            return Optional.empty();
        }
        return Layer3Type.of(Layer3Header.RADIO_RESOURCE, layer3.octet(1), Direction.UPLINK)
                .flatMap(type -> event(type, layer3).map(event -> new ChannelOutcome(type.title(), event)));
    }

    private static Optional<ConnectionEvent> event(Layer3Type type, OctetString layer3) {
        return switch (type) {
            case ASSIGNMENT_COMPLETE, HANDOVER_COMPLETE -> Optional.of(ConnectionEvent.COMPLETED);
            case ASSIGNMENT_FAILURE, HANDOVER_FAILURE -> Optional.of(ConnectionEvent.RETURNED);
            case CHANNEL_MODE_MODIFY_ACKNOWLEDGE ->
                Optional.of(isSpeechAccepted(layer3) ? ConnectionEvent.MODE_ACCEPTED : ConnectionEvent.MODE_REFUSED);
            default -> Optional.empty();
        };
    }

    private static boolean isSpeechAccepted(OctetString layer3) {
        try {
            return Layer3Codec.decode(layer3.toArray(), Direction.UPLINK)
                            instanceof RadioResource.ChannelModeModifyAcknowledge acknowledge
                    && acknowledge.mode() == RadioResource.SPEECH_FULL_RATE;
        } catch (ProtocolViolation unreadable) {
            return false;
        }
    }
}
