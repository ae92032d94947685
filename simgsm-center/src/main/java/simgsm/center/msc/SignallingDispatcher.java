package simgsm.center.msc;

import java.util.Optional;
import simgsm.abis.IpaFrame;
import simgsm.abis.RslMessage;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Message;
import simgsm.air.Layer3Type;
import simgsm.air.MobilityManagement;
import simgsm.air.ProtocolViolation;
import simgsm.air.RadioResource;
import simgsm.air.ShortMessageControl;
import simgsm.air.SupplementaryService;
import simgsm.air.answer.ProtocolErrorAnswers;
import simgsm.center.msc.call.CallSwitch;
import simgsm.center.msc.link.Link;
import simgsm.center.msc.link.MobileUplink;
import simgsm.center.msc.link.Trace;
import simgsm.center.msc.mobility.MobilityProcedures;
import simgsm.center.msc.sms.MobileMessages;
import simgsm.center.msc.ss.UssdDialogues;
import simgsm.octets.OctetString;
import simgsm.trace.MessageText;

/** Decodes uplink signalling and passes each message to its protocol. */
final class SignallingDispatcher implements MobileUplink {
    private final MobilityProcedures mobility;
    private final CallSwitch calls;
    private final MobileMessages shortMessages;
    private final UssdDialogues services;
    private final Trace trace;

    SignallingDispatcher(
            MobilityProcedures mobility,
            CallSwitch calls,
            MobileMessages shortMessages,
            UssdDialogues services,
            Trace trace) {
        this.mobility = mobility;
        this.calls = calls;
        this.shortMessages = shortMessages;
        this.services = services;
        this.trace = trace;
    }

    /** Opens SAPI 3 on an existing connection; any other message begins a new connection, and the old one is lost. */
    @Override
    public void established(Link link, RslMessage.Sapi sapi, OctetString layer3) {
        boolean isSecondLink =
                sapi == RslMessage.Sapi.SHORT_MESSAGES && link.radio().isEstablished();
        if (!isSecondLink) {
            abandon(link);
            link.radio().established();
        }
        received(link, layer3);
    }

    @Override
    public void left(Link link) {
        abandon(link);
        link.radio().left();
    }

    @Override
    public void spoke(Link link, IpaFrame frame) {
        if (CallSwitch.isRtp(frame.payload())) {
            calls.switchSpeech(link, frame);
        } else {
            link.violated("sent speech that is no RTP packet of version 2");
        }
    }

    @Override
    public void speechRefused(Link link, Cause cause) {
        calls.speechRefused(link, cause);
    }

    private static void abandon(Link link) {
        if (link.radio().isEstablished()) {
            link.loseTransactions();
        }
    }

    @Override
    public void received(Link link, OctetString layer3) {
        link.touch();
        if (!link.radio().isEstablished()) {
            return;
        }
        byte[] octets = layer3.toArray();
        int sequence = Layer3Codec.sendSequence(octets);
        if (sequence >= 0 && !link.radio().acceptsSequence(sequence)) {
            link.violated("repeated a message, N(SD) " + sequence + "; dropped");
            return;
        }
        try {
            Layer3Message message = Layer3Codec.decode(octets, Direction.UPLINK);
            trace.passed(link, Direction.UPLINK, MessageText.nameOf(message, Direction.UPLINK), layer3);
            dispatch(link, message);
        } catch (ProtocolViolation violation) {
            refuse(link, layer3, violation);
        }
    }

    private void refuse(Link link, OctetString layer3, ProtocolViolation violation) {
        trace.passed(
                link,
                Direction.UPLINK,
                violation.header().map(Layer3Header::name).orElse("?"),
                layer3);
        int callState = violation
                .header()
                .flatMap(Layer3Header::transaction)
                .flatMap(transaction -> calls.leg(link, transaction))
                .map(leg -> leg.state().code())
                .orElse(0);
        ProtocolErrorAnswers.to(violation, callState).forEach(link::send);
        link.radio().takeService();
        link.violated(violation.getMessage());
        if (isType(violation, Layer3Type.IDENTITY_RESPONSE)) {
            mobility.identityInvalid(link);
        }
    }

    private static boolean isType(ProtocolViolation violation, Layer3Type type) {
        return violation.header().flatMap(Layer3Header::type).equals(Optional.of(type));
    }

    private static boolean isEmergencyCall(Link link, Layer3Message message) {
        return message instanceof CallControl && link.radio().emergencyCaller().isPresent();
    }

    private void dispatch(Link link, Layer3Message message) {
        if (message instanceof MobilityManagement mobilityMessage) {
            mobility.receive(link, mobilityMessage);
        } else if (message instanceof RadioResource.PagingResponse response) {
            mobility.receivePagingResponse(link, response);
        } else if (message instanceof RadioResource) {
            return;
        } else if (!link.hasSubscriber() && !isEmergencyCall(link, message)) {
            link.violated("sent " + MessageText.nameOf(message, Direction.UPLINK) + " without being registered");
        } else if (message instanceof CallControl callControl) {
            calls.receive(link, callControl);
        } else if (message instanceof SupplementaryService service) {
            services.receive(link, service);
        } else {
            shortMessages.receive(link, (ShortMessageControl) message);
        }
    }
}
