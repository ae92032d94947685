package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.Optional;
import simgsm.abis.RslCodec;
import simgsm.abis.RslMessage;
import simgsm.air.CallControl;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Message;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.ProtocolErrorAnswers;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.ShortMessageControl;
import simgsm.octets.OctetString;

/** Brings what comes down the radio link to the machine that it is for, and answers what breaks the protocol. */
final class Dispatcher {
    private final StationParts parts;
    private final MobileRegistration registration;
    private final ServiceRequests services;
    private final MobilityMessages mobility;
    private final MobileCall call;
    private final CallMessages calls;
    private final ShortMessages messages;

    Dispatcher(
            StationParts parts,
            MobileRegistration registration,
            ServiceRequests services,
            MobilityMessages mobility,
            MobileCall call,
            KeySignalling keys,
            ShortMessages messages) {
        this.parts = parts;
        this.registration = registration;
        this.services = services;
        this.mobility = mobility;
        this.call = call;
        this.calls = new CallMessages(parts, call, keys);
        this.messages = messages;
    }

    void arrived(byte[] payload) {
        try {
            arrived(RslCodec.decode(payload));
        } catch (ProtocolViolation e) {
            parts.log().trace(Level.WARNING, "radio link message dropped: {0}", e.getMessage());
        }
    }

    private void arrived(RslMessage message) {
        if (message instanceof RslMessage.DataRequest request) {
            layer3Arrived(request.layer3());
        } else if (message instanceof RslMessage.PagingCommand paging) {
            paged(paging.identity());
        } else if (message instanceof RslMessage.SmsBroadcastCommand broadcast) {
            if (registration.isPowered()) {
                messages.broadcastArrived(broadcast.page());
            }
        } else {
            parts.log()
                    .trace(
                            Level.WARNING,
                            "{0} never goes down: dropped",
                            message.getClass().getSimpleName());
        }
    }

    private void layer3Arrived(OctetString octets) {
        if (!parts.radio().isOpen()) {
            parts.log().trace(Level.DEBUG, "{0} came after the channel''s release: dropped", octets);
            return;
        }
        try {
            Layer3Message message = Layer3Codec.decode(octets.toArray(), Direction.DOWNLINK);
            parts.log().trace(Level.DEBUG, "down {0}", message);
            arrived(message);
        } catch (ProtocolViolation e) {
            parts.log().trace(Level.WARNING, "{0}", e.getMessage());
            violated(e);
        }
    }

    private void arrived(Layer3Message message) {
        if (message instanceof CallControl callControl) {
            calls.arrived(callControl);
        } else if (message instanceof MobilityManagement mobilityManagement) {
            mobility.arrived(mobilityManagement);
        } else if (message instanceof ShortMessageControl shortMessage) {
            messages.arrived(shortMessage);
        } else if (message instanceof ChannelRelease) {
            channelReleased();
        } else if (message instanceof RadioResource) {
            parts.log().trace(Level.INFO, "{0}", message);
        }
    }

    private void violated(ProtocolViolation violation) {
        Optional<Layer3Header> header = violation.header();
        if (header.isPresent() && header.get().discriminator() == Layer3Header.CALL_CONTROL) {
            calls.violated(violation, header.get());
        } else {
            ProtocolErrorAnswers.to(violation, call.state().code()).forEach(parts.radio()::send);
        }
    }

    /** TS 44.018, 3.4.13.1. Whoever used the channel hears of it, registration first, because the others depend on it. */
    private void channelReleased() {
        parts.radio().release();
        registration.channelReleased();
        messages.radioLost();
        services.channelReleased();
    }

    /**
     * TS 44.018, 3.3.2: an own connection that crossed the paging serves the network as well. The answer names the
     * identity that was paged: a network that pages by the permanent one may have missed which temporary one we took.
     */
    private void paged(MobileIdentity identity) {
        if (registration.isRegistered()
                && registration.isMine(identity)
                && !parts.radio().isOpen()) {
            parts.radio().send(new PagingResponse(registration.keySequence(), identity));
        }
    }
}
