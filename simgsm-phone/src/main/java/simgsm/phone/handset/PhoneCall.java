package simgsm.phone.handset;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.CallPhase;
import simgsm.station.context.StationEvent;

/** The handset's one call: its phase, its keys in both directions, its duration. */
final class PhoneCall {
    private static final int FRAMES_PER_SECOND = 50;

    private Course call = new Course(CallPhase.NONE, "", false);
    private Course held = call;
    /** The one that was held before it, when the two change places. */
    private Course formerlyHeld = call;

    /** One call; its fields are those of {@link CallSnapshot}. */
    private static final class Course {
        private static final int MAX_KEYS = 200;

        private CallPhase phase;
        private String number;
        private long frames;
        private String keyed = "";
        private String heard = "";
        private Optional<Cause> ended = Optional.empty();
        private Optional<String> waiting = Optional.empty();
        private Optional<String> held = Optional.empty();
        private boolean onHold;
        private final boolean incoming;

        Course(CallPhase phase, String number, boolean incoming) {
            this.phase = phase;
            this.number = number;
            this.incoming = incoming;
        }

        void changeTo(CallPhase next, Optional<Cause> cause) {
            phase = next;
            ended = cause;
            waiting = Optional.empty();
            onHold = false;
        }

        static String newest(String keys) {
            return keys.substring(Math.max(0, keys.length() - MAX_KEYS));
        }
    }

    CallPhase phase() {
        return call.phase;
    }

    CallSnapshot snapshot() {
        return new CallSnapshot(
                call.phase,
                call.number,
                (int) (call.frames / FRAMES_PER_SECOND),
                call.keyed,
                call.heard,
                call.ended,
                call.waiting,
                call.held,
                call.onHold,
                call.incoming);
    }

    void accept(StationEvent.OfCall event) {
        if (event instanceof StationEvent.Calling calling) {
            begin(CallPhase.CALLING, calling.number().toString(), false);
        } else if (event instanceof StationEvent.Ringing ringing) {
            begin(CallPhase.RINGING, digits(ringing.from()), true);
        } else if (event instanceof StationEvent.CalledPartyAlerted) {
            call.phase = CallPhase.ALERTING;
        } else if (event instanceof StationEvent.Connected connected) {
            connected(connected.peer().map(Msisdn::toString).orElse(call.number));
        } else if (event instanceof StationEvent.CallWaits waiting) {
            call.waiting = Optional.of(digits(waiting.from()));
        } else if (event instanceof StationEvent.WaitingCallEnded) {
            call.waiting = Optional.empty();
        } else if (event instanceof StationEvent.CallHeld held) {
            park(digits(held.peer()));
        } else if (event instanceof StationEvent.CallRetrieved retrieved) {
            retrieve(digits(retrieved.peer()));
        } else if (event instanceof StationEvent.HeldByPeer) {
            call.onHold = true;
        } else if (event instanceof StationEvent.RetrievedByPeer) {
            call.onHold = false;
        } else if (event instanceof StationEvent.HeldCallEnded) {
            call.held = Optional.empty();
        } else if (event instanceof StationEvent.Released released) {
            call.changeTo(CallPhase.NONE, Optional.of(released.cause()));
        }
    }

    /** A waiting call is answered without ringing first. */
    private void connected(String number) {
        if (phase() == CallPhase.NONE) {
            begin(CallPhase.CONNECTED, number, true);
        }
        call.phase = CallPhase.CONNECTED;
        call.number = number;
    }

    /** The current call is held; another may become the current one. */
    private void park(String number) {
        formerlyHeld = held;
        held = call;
        call = new Course(CallPhase.NONE, "", false);
        call.held = Optional.of(number);
    }

    /** The call goes on as it was before it was held. */
    private void retrieve(String number) {
        Optional<String> other = call.held.filter(party -> !party.equals(number));
        call = other.isPresent() ? formerlyHeld : held;
        call.changeTo(CallPhase.CONNECTED, Optional.empty());
        call.number = number;
        call.held = other;
    }

    private void begin(CallPhase phase, String number, boolean incoming) {
        Optional<String> party = call.held;
        call = new Course(phase, number, incoming);
        call.held = party;
    }

    private static String digits(Optional<Msisdn> number) {
        return number.map(Msisdn::toString).orElse("");
    }

    /** The cause of the last release is no longer shown. */
    void clearCause() {
        call.ended = Optional.empty();
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
        call.keyed = Course.newest(call.keyed + key.symbol());
    }

    void toneHeard(DtmfKey key) {
        call.heard = Course.newest(call.heard + key.symbol());
    }

    /** 20 ms of speech have passed. @return whether the duration has reached a further second */
    boolean framePassed() {
        return phase() == CallPhase.CONNECTED && ++call.frames % FRAMES_PER_SECOND == 0;
    }
}
