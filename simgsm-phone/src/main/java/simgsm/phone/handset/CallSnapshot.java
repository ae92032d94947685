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
 * @param tone the key heard last from the far end
 * @param ended why the last call ended, until the next key or call
 */
public record CallSnapshot(
        CallPhase phase, String number, int seconds, String keyed, Optional<DtmfKey> tone, Optional<Cause> ended) {
    static final CallSnapshot NONE = new CallSnapshot(CallPhase.NONE, "", 0, "", Optional.empty(), Optional.empty());
}
