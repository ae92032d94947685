package simgsm.phone.handset;

import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.CallPhase;
import simgsm.station.context.StationEvent;

/** The handset's one call: its phase, its keys in both directions, its duration. */
final class PhoneCall {
    private static final int FRAMES_PER_SECOND = 50;

    private CallSnapshot call = CallSnapshot.NONE;
    private long frames;
    private Parked held = new Parked(CallSnapshot.NONE, 0);
    /** The one that was held before it, when the two change places. */
    private Parked formerlyHeld = held;

    /** A held call as it was. */
    private record Parked(CallSnapshot call, long frames) {}

    CallPhase phase() {
        return call.phase();
    }

    CallSnapshot snapshot() {
        call = call.at((int) (frames / FRAMES_PER_SECOND));
        return call;
    }

    void accept(StationEvent.OfCall event) {
        if (event instanceof StationEvent.Calling calling) {
            begin(CallPhase.CALLING, calling.number().toString(), false);
        } else if (event instanceof StationEvent.Ringing ringing) {
            begin(CallPhase.RINGING, digits(ringing.from()), true);
        } else if (event instanceof StationEvent.CalledPartyAlerted) {
            call = call.in(CallPhase.ALERTING, call.number());
        } else if (event instanceof StationEvent.Connected connected) {
            connected(connected.peer().map(Msisdn::toString).orElse(call.number()));
        } else if (event instanceof StationEvent.CallWaits waiting) {
            call = call.withWaiting(Optional.of(digits(waiting.from())));
        } else if (event instanceof StationEvent.WaitingCallEnded) {
            call = call.withWaiting(Optional.empty());
        } else if (event instanceof StationEvent.CallHeld held) {
            park(digits(held.peer()));
        } else if (event instanceof StationEvent.CallRetrieved retrieved) {
            retrieve(digits(retrieved.peer()));
        } else if (event instanceof StationEvent.HeldByPeer) {
            call = call.withOnHold(true);
        } else if (event instanceof StationEvent.RetrievedByPeer) {
            call = call.withOnHold(false);
        } else if (event instanceof StationEvent.HeldCallEnded) {
            call = call.withHeld(Optional.empty());
        } else if (event instanceof StationEvent.Released released) {
            call = call.ended(released.cause());
        }
    }

    /** A waiting call is answered without ringing first. */
    private void connected(String number) {
        if (phase() == CallPhase.NONE) {
            begin(CallPhase.CONNECTED, number, true);
        }
        call = call.in(CallPhase.CONNECTED, number);
    }

    /** The current call is held; another may become the current one. */
    private void park(String number) {
        formerlyHeld = held;
        held = new Parked(call, frames);
        call = CallSnapshot.begun(CallPhase.NONE, "", false).withHeld(Optional.of(number));
        frames = 0;
    }

    private void retrieve(String number) {
        boolean isSwap = call.held().filter(other -> !other.equals(number)).isPresent();
        Parked back = isSwap ? formerlyHeld : held;
        call = back.call().retrieved(number, isSwap ? call.held() : Optional.empty());
        frames = back.frames();
    }

    private void begin(CallPhase phase, String number, boolean incoming) {
        call = CallSnapshot.begun(phase, number, incoming).withHeld(call.held());
        frames = 0;
    }

    private static String digits(Optional<Msisdn> number) {
        return number.map(Msisdn::toString).orElse("");
    }

    /** The cause of the last release is no longer shown. */
    void clearCause() {
        call = call.withoutCause();
    }

    /** Why keys cannot be queued now, if they cannot. */
    Optional<Refusal> refusalOfKeys() {
        return switch (phase()) {
            case NONE -> Optional.of(Refusal.NO_CALL);
            case RINGING -> Optional.of(Refusal.NOT_ANSWERED);
            default -> Optional.empty();
        };
    }

    void keyed(DtmfKey key) {
        call = call.withKeyed(key.symbol());
    }

    void toneHeard(DtmfKey key) {
        call = call.withHeard(key.symbol());
    }

    /** 20 ms of speech have passed. @return whether the duration has reached a further second */
    boolean framePassed() {
        return phase() == CallPhase.CONNECTED && ++frames % FRAMES_PER_SECOND == 0;
    }
}
