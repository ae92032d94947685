package simgsm.phone.handset;

import java.util.Optional;
import simgsm.air.Cause;
import simgsm.dtmf.DtmfKey;

/**
 * The present call, or what is left of the last one.
 *
 * @param number the other party, empty if unknown
 * @param seconds since it was connected, counted in speech
 * @param keyed what was keyed in it, newest last
 * @param heard what the far end has keyed, newest last
 * @param waiting who calls meanwhile, empty if unknown
 * @param ended why the last call ended, until the next key or call
 */
public record CallSnapshot(
        CallPhase phase,
        String number,
        int seconds,
        String keyed,
        String heard,
        Optional<Cause> ended,
        Optional<String> waiting) {
    private static final int MAX_KEYS = 200;

    static final CallSnapshot NONE = begun(CallPhase.NONE, "");

    static CallSnapshot begun(CallPhase phase, String number) {
        return new CallSnapshot(phase, number, 0, "", "", Optional.empty(), Optional.empty());
    }

    /** The key heard last from the far end. */
    public Optional<DtmfKey> tone() {
        return heard.isEmpty() ? Optional.empty() : Optional.of(DtmfKey.of(heard.charAt(heard.length() - 1)));
    }

    CallSnapshot in(CallPhase next, String itsNumber) {
        return new CallSnapshot(next, itsNumber, seconds, keyed, heard, ended, waiting);
    }

    CallSnapshot at(int nowSeconds) {
        return new CallSnapshot(phase, number, nowSeconds, keyed, heard, ended, waiting);
    }

    CallSnapshot withKeyed(char key) {
        return new CallSnapshot(phase, number, seconds, newest(keyed + key), heard, ended, waiting);
    }

    CallSnapshot withHeard(char key) {
        return new CallSnapshot(phase, number, seconds, keyed, newest(heard + key), ended, waiting);
    }

    CallSnapshot over(Cause cause) {
        return new CallSnapshot(CallPhase.NONE, number, seconds, keyed, heard, Optional.of(cause), Optional.empty());
    }

    CallSnapshot withWaiting(Optional<String> who) {
        return new CallSnapshot(phase, number, seconds, keyed, heard, ended, who);
    }

    CallSnapshot withoutEnd() {
        return new CallSnapshot(phase, number, seconds, keyed, heard, Optional.empty(), waiting);
    }

    private static String newest(String keys) {
        return keys.substring(Math.max(0, keys.length() - MAX_KEYS));
    }
}
