package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.Optional;
import simgsm.abis.RslMessage;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.CipherAlgorithm;
import simgsm.air.Direction;
import simgsm.air.Imeisv;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Message;
import simgsm.air.MobileIdentity;
import simgsm.air.MobilityManagement;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.air.RadioResource.ChannelRelease;
import simgsm.air.RadioResource.CipheringModeCommand;
import simgsm.air.RadioResource.CipheringModeComplete;
import simgsm.air.RadioResource.ClassmarkChange;
import simgsm.air.RadioResource.ClassmarkEnquiry;
import simgsm.air.RadioResource.PagingResponse;
import simgsm.air.RadioResource.RrStatus;
import simgsm.air.ShortMessageControl;
import simgsm.air.SupplementaryService;
import simgsm.air.answer.ProtocolErrorAnswers;
import simgsm.octets.OctetString;
import simgsm.station.call.KeySignalling;
import simgsm.station.call.MobileCall;
import simgsm.station.call.MobileCallMessages;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;
import simgsm.station.mobility.MobileRegistration;
import simgsm.station.mobility.MobileRegistrationTable.MobileRegistrationEvent;
import simgsm.station.mobility.MobilityMessages;
import simgsm.station.mobility.ServiceRequests;
import simgsm.station.sms.ShortMessages;
import simgsm.station.ss.MobileUssd;

/** Passes messages of the radio link to their machines and answers protocol errors. */
final class MessageDispatcher {
    private final StationContext context;
    private final MobileRegistration registration;
    private final ServiceRequests services;
    private final MobilityMessages mobility;
    private final MobileCall call;
    private final MobileCallMessages calls;
    private final ShortMessages messages;
    private final MobileUssd ussd;
    private final CellReception reception;

    MessageDispatcher(
            StationContext context,
            MobileRegistration registration,
            ServiceRequests services,
            MobilityMessages mobility,
            MobileCall call,
            KeySignalling keys,
            ShortMessages messages,
            MobileUssd ussd,
            CellReception reception) {
        this.context = context;
        this.registration = registration;
        this.services = services;
        this.mobility = mobility;
        this.call = call;
        this.calls = new MobileCallMessages(context, call, keys);
        this.messages = messages;
        this.ussd = ussd;
        this.reception = reception;
    }

    void arrived(byte[] payload) {
        try {
            arrived(RslMessage.decode(payload));
        } catch (ProtocolViolation e) {
            context.log().trace(Level.WARNING, "radio link message dropped: {0}", e.getMessage());
        }
    }

    private void arrived(RslMessage message) throws ProtocolViolation {
        if (message instanceof RslMessage.DataRequest request) {
            layer3Arrived(request.layer3());
        } else if (message instanceof RslMessage.PagingCommand paging) {
            paged(paging.identity());
        } else if (message instanceof RslMessage.BroadcastInformation information) {
            reception.arrived(information);
            reception
                    .information()
                    .ifPresent(cell ->
                            registration.camped(cell.area(), cell.control().t3212()));
        } else if (message instanceof RslMessage.MeasurementResult result) {
            reception.arrived(result);
        } else if (message instanceof RslMessage.SmsBroadcastCommand broadcast) {
            if (registration.isPowered()) {
                messages.broadcastArrived(broadcast.page());
            }
        } else {
            context.log()
                    .trace(
                            Level.WARNING,
                            "{0} is not for a station: dropped",
                            message.getClass().getSimpleName());
        }
    }

    private void layer3Arrived(OctetString octets) {
        if (!context.radio().isOpen()) {
            context.log().trace(Level.DEBUG, "{0} after the channel''s release: dropped", octets);
            return;
        }
        try {
            Layer3Message message = Layer3Codec.decode(octets.toArray(), Direction.DOWNLINK);
            context.log().trace(Level.DEBUG, "down {0}", message);
            context.events().add(new StationEvent.MessagePassed(Direction.DOWNLINK, message));
            arrived(message);
        } catch (ProtocolViolation e) {
            context.log().trace(Level.WARNING, "{0}", e.getMessage());
            violated(e);
        }
    }

    private void arrived(Layer3Message message) {
        if (!(message instanceof RadioResource)) {
            registration.contacted();
        }
        if (message instanceof CallControl callControl) {
            calls.arrived(callControl);
        } else if (message instanceof MobilityManagement mobilityManagement) {
            mobility.arrived(mobilityManagement);
        } else if (message instanceof ShortMessageControl shortMessage) {
            messages.arrived(shortMessage);
        } else if (message instanceof SupplementaryService service) {
            ussd.arrived(service);
        } else if (message instanceof ChannelRelease) {
            channelReleased();
        } else if (message instanceof CipheringModeCommand command) {
            cipher(command);
        } else if (message instanceof ClassmarkEnquiry) {
            context.radio().send(new ClassmarkChange());
        } else if (message instanceof RrStatus status) {
            context.log().trace(Level.INFO, "{0}", status);
        } else {
            context.radio().send(new RrStatus(Cause.MESSAGE_TYPE_NON_EXISTENT.code()));
        }
    }

    /** Ciphers with the SIM's key, which the towers apply to the air. What is no valid change is refused (TS 44.018, 3.4.7.2). */
    private void cipher(CipheringModeCommand command) {
        boolean starts = command.algorithm() != CipherAlgorithm.A5_0;
        boolean isPossible = command.algorithm() != CipherAlgorithm.A5_2
                && registration.cipherKey().isPresent()
                && !context.radio().isCiphered();
        if (starts && !isPossible) {
            context.radio().send(new RrStatus(Cause.PROTOCOL_ERROR.code()));
            return;
        }
        context.radio().cipher(command, registration.cipherKey());
        context.radio()
                .send(new CipheringModeComplete(
                        command.response() != 0
                                ? Optional.of(Imeisv.of(context.identity().imei()))
                                : Optional.empty()));
        if (starts) {
            // it answers a CM SERVICE REQUEST, in place of CM SERVICE ACCEPT (TS 24.008, 4.5.1.1)
            services.accepted();
        }
    }

    private void violated(ProtocolViolation violation) {
        Optional<Layer3Header> header = violation.header();
        if (header.isPresent() && header.get().discriminator() == Layer3Header.CALL_CONTROL) {
            calls.violated(violation, header.get());
        } else {
            ProtocolErrorAnswers.to(violation, call.state().code()).forEach(context.radio()::send);
        }
    }

    /** TS 44.018, 3.4.13.1. Registration is first, because the others depend on it. */
    private void channelReleased() {
        context.radio().release();
        registration.fire(MobileRegistrationEvent.CHANNEL_RELEASED);
        messages.radioLost();
        services.channelReleased();
    }

    /**
     * TS 44.018, 3.3.2. An open connection needs no answer: the network uses it. The answer has the paged identity,
     * because a network that pages by the IMSI may not know the accepted TMSI.
     */
    private void paged(MobileIdentity identity) {
        if (registration.isRegistered()
                && registration.isOwn(identity)
                && !context.radio().isOpen()) {
            context.radio().send(new PagingResponse(registration.keySequence(), identity));
        }
    }
}
