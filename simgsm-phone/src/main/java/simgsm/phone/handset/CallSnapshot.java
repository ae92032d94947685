package simgsm.phone.handset;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.CallPhase;

/**
 * The current call, or the last one.
 *
 * @param number of the other party, empty if unknown
 * @param seconds since the call was connected, counted in speech
 * @param keyed the keys sent, newest last
 * @param heard the keys received, newest last
 * @param ended the cause of the release, until the next key or call
 * @param waiting number of a second caller, empty text if unknown
 * @param held number of the party whose call is held, empty text if unknown
 * @param onHold whether the other party holds this call
 * @param incoming whether the other party called: no robot does
 */
public record CallSnapshot(
        CallPhase phase,
        String number,
        int seconds,
        String keyed,
        String heard,
        Optional<Cause> ended,
        Optional<String> waiting,
        Optional<String> held,
        boolean onHold,
        boolean incoming) {
    private static final int MAX_KEYS = 200;

    static final CallSnapshot NONE = begun(CallPhase.NONE, "", false);

    static CallSnapshot begun(CallPhase phase, String number, boolean incoming) {
        return new CallSnapshot(
                phase, number, 0, "", "", Optional.empty(), Optional.empty(), Optional.empty(), false, incoming);
    }

    /** The newest key from the far end. */
    public Optional<DtmfKey> tone() {
        return heard.isEmpty() ? Optional.empty() : Optional.of(DtmfKey.of(heard.charAt(heard.length() - 1)));
    }

    /** The key of a tone's meaning in a robot's replies; empty for other tones, and for a caller's: no robot calls. */
    public Optional<String> meaningOf(DtmfKey key) {
        return incoming ? Optional.empty() : ToneMeaning.textKey(key);
    }

    CallSnapshot in(CallPhase next, String newNumber) {
        return new CallSnapshot(next, newNumber, seconds, keyed, heard, ended, waiting, held, onHold, incoming);
    }

    /** The call goes on as it was before it was held. */
    CallSnapshot retrieved(String newNumber, Optional<String> nowHeld) {
        return new CallSnapshot(
                CallPhase.CONNECTED,
                newNumber,
                seconds,
                keyed,
                heard,
                Optional.empty(),
                Optional.empty(),
                nowHeld,
                false,
                incoming);
    }

    CallSnapshot at(int newSeconds) {
        return new CallSnapshot(phase, number, newSeconds, keyed, heard, ended, waiting, held, onHold, incoming);
    }

    CallSnapshot withKeyed(char key) {
        return new CallSnapshot(
                phase, number, seconds, newest(keyed + key), heard, ended, waiting, held, onHold, incoming);
    }

    CallSnapshot withHeard(char key) {
        return new CallSnapshot(
                phase, number, seconds, keyed, newest(heard + key), ended, waiting, held, onHold, incoming);
    }

    CallSnapshot ended(Cause cause) {
        return new CallSnapshot(
                CallPhase.NONE,
                number,
                seconds,
                keyed,
                heard,
                Optional.of(cause),
                Optional.empty(),
                held,
                false,
                incoming);
    }

    CallSnapshot withWaiting(Optional<String> caller) {
        return new CallSnapshot(phase, number, seconds, keyed, heard, ended, caller, held, onHold, incoming);
    }

    CallSnapshot withHeld(Optional<String> party) {
        return new CallSnapshot(phase, number, seconds, keyed, heard, ended, waiting, party, onHold, incoming);
    }

    CallSnapshot withOnHold(boolean nowOnHold) {
        return new CallSnapshot(phase, number, seconds, keyed, heard, ended, waiting, held, nowOnHold, incoming);
    }

    CallSnapshot withoutCause() {
        return new CallSnapshot(
                phase, number, seconds, keyed, heard, Optional.empty(), waiting, held, onHold, incoming);
    }

    private static String newest(String keys) {
        return keys.substring(Math.max(0, keys.length() - MAX_KEYS));
    }
}
