package simgsm.phone.handset;

import java.time.Instant;
import java.time.InstantSource;
import java.util.Optional;
import simgsm.air.Msisdn;
import simgsm.phone.store.CallLog;
import simgsm.phone.store.CallRecord;
import simgsm.phone.store.CallRecord.Kind;
import simgsm.station.context.StationEvent;

/** Writes each call of the station to the log when it ends. */
final class CallHistory {
    private final CallLog log;
    private final InstantSource wallClock;
    private Kind kind;
    private String number = "";
    private Instant at;
    private boolean isTaken;
    private Optional<String> waiting = Optional.empty();
    private Instant waitingAt;

    CallHistory(CallLog log, InstantSource wallClock) {
        this.log = log;
        this.wallClock = wallClock;
    }

    /** The user takes or refuses the ringing call, so that it is not a missed one. */
    void taken() {
        isTaken = true;
    }

    /** @param seconds of conversation so far */
    void accept(StationEvent.OfCall event, int seconds) {
        if (event instanceof StationEvent.Calling calling) {
            begin(Kind.DIALLED, calling.number().digits(), wallClock.instant());
        } else if (event instanceof StationEvent.Ringing ringing) {
            boolean waited = waiting.isPresent();
            begin(Kind.MISSED, digits(ringing.from()), waited ? waitingAt : wallClock.instant());
            waiting = Optional.empty();
        } else if (event instanceof StationEvent.Connected) {
            isTaken = true;
        } else if (event instanceof StationEvent.Released && kind != null) {
            log.add(new CallRecord(kind == Kind.MISSED && isTaken ? Kind.RECEIVED : kind, number, at, seconds));
            kind = null;
        } else if (event instanceof StationEvent.CallWaits waits) {
            waiting = Optional.of(digits(waits.from()));
            waitingAt = wallClock.instant();
        } else if (event instanceof StationEvent.WaitingCallEnded) {
            waiting.ifPresent(caller -> log.add(new CallRecord(Kind.MISSED, caller, waitingAt, 0)));
            waiting = Optional.empty();
        }
    }

    private void begin(Kind newKind, String newNumber, Instant begun) {
        kind = newKind;
        number = newNumber;
        at = begun;
        isTaken = false;
    }

    private static String digits(Optional<Msisdn> from) {
        return from.map(Msisdn::digits).orElse("");
    }
}
