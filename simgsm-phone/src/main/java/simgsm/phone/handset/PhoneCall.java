package simgsm.phone.handset;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.CallPhase;
import simgsm.phone.screen.HomeKeys;
import simgsm.station.StationCommands;
import simgsm.station.context.StationEvent;

/** The handset's calls: the current one with its keys in both directions and its duration, a held one, and a waiting one. */
final class PhoneCall {
    private static final int FRAMES_PER_SECOND = 50;
    private static final int MAX_KEYS = 200;

    private Party current = new Party(CallPhase.NONE, "", false);
    private Party parked = current;
    /** The party held before {@link #parked}, while the two are being swapped. */
    private Party formerlyParked = current;

    private Optional<Cause> ended = Optional.empty();
    private Optional<String> waiting = Optional.empty();
    private Optional<String> held = Optional.empty();
    private boolean isRingSilent;

    /** The call with one other party. */
    private static final class Party {
        private final boolean isIncoming;
        private CallPhase phase;
        private String number;
        private String keyed = "";
        private String heard = "";
        private String words = "";
        private boolean isOnHold;
        private long frames;

        Party(CallPhase phase, String number, boolean isIncoming) {
            this.phase = phase;
            this.number = number;
            this.isIncoming = isIncoming;
        }
    }

    CallPhase phase() {
        return current.phase;
    }

    /** Calls a number unless a call is under way. */
    Optional<Refusal> dial(StationCommands station, Msisdn number) {
        if (!station.snapshot().powered()) {
            return Optional.of(Refusal.SWITCHED_OFF);
        }
        if (!number.isEmergency() && !station.snapshot().card().isReady()) {
            return Optional.of(Refusal.SIM_LOCKED);
        }
        return current.phase == CallPhase.NONE && station.dial(number)
                ? Optional.empty()
                : Optional.of(Refusal.CALL_UNDER_WAY);
    }

    CallSnapshot snapshot() {
        return new CallSnapshot(
                current.phase,
                current.number,
                (int) (current.frames / FRAMES_PER_SECOND),
                current.keyed,
                current.heard,
                current.words,
                ended,
                waiting,
                held,
                current.isOnHold,
                current.isIncoming);
    }

    /** The state that determines the keys of the home screen. */
    HomeKeys.Situation situation(int unread, int missed) {
        return new HomeKeys.Situation(
                current.phase, isRingSilent, waiting.isPresent(), held.isPresent(), unread, missed);
    }

    void accept(StationEvent.OfCall event) {
        if (event instanceof StationEvent.Calling calling) {
            begin(CallPhase.CALLING, calling.number().toString(), false);
        } else if (event instanceof StationEvent.Ringing ringing) {
            begin(CallPhase.RINGING, digits(ringing.from()), true);
        } else if (event instanceof StationEvent.CalledPartyAlerted) {
            current.phase = CallPhase.ALERTING;
        } else if (event instanceof StationEvent.Connected connected) {
            connected(connected.peer().map(Msisdn::toString).orElse(current.number));
        } else if (event instanceof StationEvent.CallWaits caller) {
            waiting = Optional.of(digits(caller.from()));
        } else if (event instanceof StationEvent.WaitingCallEnded) {
            waiting = Optional.empty();
        } else if (event instanceof StationEvent.CallHeld party) {
            park(digits(party.peer()));
        } else if (event instanceof StationEvent.CallRetrieved party) {
            retrieve(digits(party.peer()));
        } else if (event instanceof StationEvent.HeldByPeer) {
            current.isOnHold = true;
        } else if (event instanceof StationEvent.RetrievedByPeer) {
            current.isOnHold = false;
        } else if (event instanceof StationEvent.HeldCallEnded) {
            held = Optional.empty();
        } else if (event instanceof StationEvent.Released released) {
            become(current, CallPhase.NONE, current.number);
            ended = Optional.of(released.cause());
        }
    }

    /** A waiting call is answered without ringing first. */
    private void connected(String number) {
        if (phase() == CallPhase.NONE) {
            begin(CallPhase.CONNECTED, number, true);
        }
        current.phase = CallPhase.CONNECTED;
        current.number = number;
    }

    /** Holds the current call, so that another can become the current one. */
    private void park(String number) {
        formerlyParked = parked;
        parked = current;
        begin(CallPhase.NONE, "", false);
        held = Optional.of(number);
    }

    private void retrieve(String number) {
        boolean isSwap = held.filter(other -> !other.equals(number)).isPresent();
        become(isSwap ? formerlyParked : parked, CallPhase.CONNECTED, number);
        held = isSwap ? held : Optional.empty();
    }

    private void begin(CallPhase phase, String number, boolean incoming) {
        become(new Party(phase, number, incoming), phase, number);
        isRingSilent = false;
    }

    private void become(Party party, CallPhase phase, String number) {
        current = party;
        current.phase = phase;
        current.number = number;
        current.isOnHold = false;
        ended = Optional.empty();
        waiting = Optional.empty();
    }

    /** The number's digits, or an empty text for an unknown number. */
    static String digits(Optional<Msisdn> number) {
        return number.map(Msisdn::toString).orElse("");
    }

    /** Stops showing the cause of the last release. */
    void clearCause() {
        ended = Optional.empty();
    }

    /** Notes that the user has ended the ringing sound of the current call. */
    void silenced() {
        isRingSilent = true;
    }

    /** The reason why keys cannot be queued now; empty if they can. */
    Optional<Refusal> refusalOfKeys() {
        return switch (phase()) {
            case NONE -> Optional.of(Refusal.NO_CALL);
            case RINGING -> Optional.of(Refusal.NOT_ANSWERED);
            default -> Optional.empty();
        };
    }

    void keyed(DtmfKey key) {
        current.keyed = newest(current.keyed + key.symbol());
    }

    HandsetEvent toneHeard(DtmfKey key) {
        current.heard = newest(current.heard + key.symbol());
        current.words = "";
        return new HandsetEvent.ToneHeard(key, snapshot().meaningOf(key));
    }

    HandsetEvent wordsHeard(String text) {
        current.words = text;
        return new HandsetEvent.WordsHeard(text);
    }

    private static String newest(String keys) {
        return keys.substring(Math.max(0, keys.length() - MAX_KEYS));
    }

    /** Counts 20 ms of speech. @return true if the duration has reached a further second */
    boolean framePassed() {
        return phase() == CallPhase.CONNECTED && ++current.frames % FRAMES_PER_SECOND == 0;
    }
}
