package simgsm.phone.handset;

import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import simgsm.phone.store.CallLog;
import simgsm.phone.store.CallRecord;
import simgsm.phone.store.CallRecord.Kind;
import simgsm.station.context.StationEvent;

/** Writes each call of the station to the log when it ends. */
final class CallHistory {
    /** A call that has not ended. @param kind MISSED until the call is taken */
    private record Begun(Kind kind, String number, Instant at) {
        CallRecord ended(boolean isTaken, int seconds) {
            return new CallRecord(kind == Kind.MISSED && isTaken ? Kind.RECEIVED : kind, number, at, seconds);
        }
    }

    private final CallLog log;
    private final InstantSource wallClock;
    private Optional<Begun> current = Optional.empty();
    private boolean isTaken;
    private Optional<Begun> held = Optional.empty();
    private int heldSeconds;
    /** The call held before {@link #held}, while the two are being swapped. */
    private Optional<Begun> formerlyHeld = Optional.empty();

    private Optional<String> waiting = Optional.empty();
    private Instant waitingAt;

    CallHistory(CallLog log, InstantSource wallClock) {
        this.log = log;
        this.wallClock = wallClock;
    }

    /** The user takes or refuses the ringing call, which is not missed then. */
    void taken() {
        isTaken = true;
    }

    /** @param seconds of conversation so far, in the current call */
    void accept(StationEvent.OfCall event, int seconds) {
        if (event instanceof StationEvent.Calling calling) {
            begin(Kind.DIALLED, calling.number().toString(), wallClock.instant());
        } else if (event instanceof StationEvent.Ringing ringing) {
            begin(Kind.MISSED, PhoneCall.digits(ringing.from()), waiting.isPresent() ? waitingAt : wallClock.instant());
            waiting = Optional.empty();
        } else if (event instanceof StationEvent.Connected) {
            // A waiting call is answered without ringing first.
            current = current.or(() -> waiting.map(caller -> new Begun(Kind.MISSED, caller, waitingAt)));
            waiting = Optional.empty();
            isTaken = true;
        } else if (event instanceof StationEvent.Released) {
            current.ifPresent(begun -> log.add(begun.ended(isTaken, seconds)));
            current = Optional.empty();
        } else if (event instanceof StationEvent.CallWaits waits) {
            waiting = Optional.of(PhoneCall.digits(waits.from()));
            waitingAt = wallClock.instant();
        } else if (event instanceof StationEvent.WaitingCallEnded) {
            waiting.ifPresent(caller -> log.add(new CallRecord(Kind.MISSED, caller, waitingAt, 0)));
            waiting = Optional.empty();
        } else {
            acceptHold(event, seconds);
        }
    }

    private void acceptHold(StationEvent.OfCall event, int seconds) {
        if (event instanceof StationEvent.CallHeld) {
            formerlyHeld = held;
            held = current;
            heldSeconds = seconds;
            current = Optional.empty();
        } else if (event instanceof StationEvent.CallRetrieved) {
            boolean isSwap = formerlyHeld.isPresent();
            current = isSwap ? formerlyHeld : held;
            held = isSwap ? held : Optional.empty();
            formerlyHeld = Optional.empty();
            isTaken = true;
        } else if (event instanceof StationEvent.HeldCallEnded) {
            held.ifPresent(begun -> log.add(begun.ended(true, heldSeconds)));
            held = Optional.empty();
        }
    }

    private void begin(Kind newKind, String newNumber, Instant begun) {
        current = Optional.of(new Begun(newKind, newNumber, begun));
        isTaken = false;
    }
}
