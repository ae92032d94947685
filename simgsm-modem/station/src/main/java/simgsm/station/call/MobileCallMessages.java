package simgsm.station.call;

import java.lang.System.Logger.Level;
import java.util.Map;
import java.util.Optional;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.air.Layer3Header;
import simgsm.air.Layer3Type;
import simgsm.air.ProtocolViolation;
import simgsm.air.TransactionIdentifier;
import simgsm.air.answer.ProtocolErrorAnswers;
import simgsm.ss.NotifySs;
import simgsm.station.call.MobileCallTable.MobileCallEvent;
import simgsm.station.call.MobileCallTable.MobileCallState;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;

/** Passes the network's call control messages to the call or the waiting call; answers those of other transactions. */
public final class MobileCallMessages {
    /** Messages that are events of the state table. */
    private static final Map<Class<? extends CallControl>, MobileCallEvent> EVENTS = Map.of(
            CallControl.CallProceeding.class, MobileCallEvent.CALL_PROCEEDING,
            CallControl.Progress.class, MobileCallEvent.PROGRESS,
            CallControl.Alerting.class, MobileCallEvent.ALERTING,
            CallControl.Connect.class, MobileCallEvent.CONNECT,
            CallControl.ConnectAcknowledge.class, MobileCallEvent.CONNECT_ACKNOWLEDGE,
            CallControl.Disconnect.class, MobileCallEvent.DISCONNECT,
            CallControl.Release.class, MobileCallEvent.RELEASE,
            CallControl.ReleaseComplete.class, MobileCallEvent.RELEASE_COMPLETE);

    private final StationContext context;
    private final MobileCall call;
    private final KeySignalling keys;

    public MobileCallMessages(StationContext context, MobileCall call, KeySignalling keys) {
        this.context = context;
        this.call = call;
        this.keys = keys;
    }

    public void arrived(CallControl message) {
        if (message instanceof CallControl.Setup setup) {
            offered(setup);
        } else if (message instanceof CallControl.Facility facility && isKnown(message)) {
            NotifySs.of(facility.facility()).ifPresent(what -> notified(facility.transaction(), what));
        } else if (isKnown(message) && call.callHold().answered(message)) {
            context.log().trace(Level.DEBUG, "{0} answers a request to hold or retrieve", message);
        } else if (call.has(message.transaction())) {
            arrivedInCall(message);
        } else if (call.second().has(message.transaction())) {
            call.second().arrived(message);
        } else {
            arrivedOutsideCall(message);
        }
    }

    private void notified(TransactionIdentifier transaction, NotifySs what) {
        switch (what) {
            case CALL_ON_HOLD -> call.heldByPeer(transaction, true);
            case CALL_RETRIEVED -> call.heldByPeer(transaction, false);
            case OUTGOING_CALL_FORWARDED -> context.events().add(new StationEvent.CallForwarded());
            case INCOMING_CALL_FORWARDED -> context.events().add(new StationEvent.IncomingCallForwarded());
            case FORWARDING_ACTIVE -> context.events().add(new StationEvent.ForwardingActive());
        }
    }

    private boolean isKnown(CallControl message) {
        return call.has(message.transaction()) || call.second().has(message.transaction());
    }

    /** A message that cannot be decoded (TS 24.008, 8): a clearing message clears, any other is answered. */
    public void violated(ProtocolViolation violation, Layer3Header header) {
        TransactionIdentifier received = header.transaction().orElseThrow();
        Optional<CallControl> clearing =
                header.type().flatMap(type -> clearing(type, received, violation.statusCause()));
        if (clearing.isPresent()) {
            arrived(clearing.get());
        } else if (call.has(received) || header.type().equals(Optional.of(Layer3Type.SETUP))) {
            ProtocolErrorAnswers.to(violation, call.state().code()).forEach(context.radio()::send);
        } else {
            refuse(received, Cause.INVALID_TRANSACTION_IDENTIFIER);
        }
    }

    private static Optional<CallControl> clearing(Layer3Type type, TransactionIdentifier received, Cause cause) {
        return Optional.ofNullable(
                switch (type) {
                    case DISCONNECT -> new CallControl.Disconnect(received, cause);
                    case RELEASE -> new CallControl.Release(received, Optional.of(cause));
                    case RELEASE_COMPLETE -> new CallControl.ReleaseComplete(received, Optional.of(cause));
                    default -> null;
                });
    }

    private void offered(CallControl.Setup setup) {
        if (call.ignoresSetup()) {
            context.log().trace(Level.INFO, "SETUP left unanswered, as the fault of this station has it");
        } else if (setup.transaction().fromOtherSide()
                || call.has(setup.transaction())
                || call.second().has(setup.transaction())) {
            context.log().trace(Level.DEBUG, "SETUP of a known or foreign transaction ignored");
        } else if (call.acceptsWaitingCall()) {
            call.second().offered(setup);
        } else if (call.state() != MobileCallState.NULL || call.callHold().isRetrieving()) {
            refuse(setup.transaction(), Cause.USER_BUSY);
        } else {
            call.offered(setup.transaction(), setup.calling());
            setup.redirecting().ifPresent(number -> context.events().add(new StationEvent.ForwardedBy(number)));
        }
    }

    /** TS 24.008, 8.3.2: an unknown transaction is released, unless the message says that the network has none either. */
    private void arrivedOutsideCall(CallControl message) {
        boolean agrees =
                message instanceof CallControl.Status status && status.callState() == MobileCallState.NULL.code();
        if (!agrees && !(message instanceof CallControl.ReleaseComplete)) {
            refuse(message.transaction(), Cause.INVALID_TRANSACTION_IDENTIFIER);
        }
    }

    private void refuse(TransactionIdentifier received, Cause cause) {
        context.radio().send(new CallControl.ReleaseComplete(received.answered(), Optional.of(cause)));
    }

    private void arrivedInCall(CallControl message) {
        if (message instanceof CallControl.StatusEnquiry) {
            call.sendStatus(Cause.RESPONSE_TO_STATUS_ENQUIRY);
            return;
        }
        if (message instanceof CallControl.Status status) {
            statusArrived(status);
            return;
        }
        if (keys.arrived(message)) {
            return;
        }
        if (message instanceof CallControl.Connect connect) {
            connect.connected().ifPresent(call::connectedTo);
        }
        MobileCallEvent event = EVENTS.get(message.getClass());
        if (event == null) {
            call.sendStatus(Cause.MESSAGE_TYPE_NON_EXISTENT);
        } else if (!call.arrived(event, causeIn(message), isInBand(message))) {
            call.sendStatus(Cause.MESSAGE_NOT_COMPATIBLE_WITH_STATE);
        }
    }

    private void statusArrived(CallControl.Status status) {
        context.log().trace(Level.INFO, "STATUS {0} in U{1}", status.cause().title(), status.callState());
        if (status.callState() == MobileCallState.NULL.code()) {
            call.arrived(MobileCallEvent.STATUS_NULL, status.cause(), false);
        }
    }

    private static boolean isInBand(CallControl message) {
        return message instanceof CallControl.Progress
                || message instanceof CallControl.Alerting alerting && alerting.inBand()
                || message instanceof CallControl.Disconnect disconnect && disconnect.inBand();
    }

    private static Cause causeIn(CallControl message) {
        if (message instanceof CallControl.Disconnect disconnect) {
            return disconnect.cause();
        }
        if (message instanceof CallControl.Release release) {
            return release.cause().orElse(Cause.NORMAL_UNSPECIFIED);
        }
        if (message instanceof CallControl.ReleaseComplete complete) {
            return complete.cause().orElse(Cause.NORMAL_UNSPECIFIED);
        }
        return Cause.NORMAL_CALL_CLEARING;
    }
}
