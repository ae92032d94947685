package simgsm.scope;

import java.util.List;
import java.util.Optional;
import simgsm.dtmf.DtmfDigit;
import simgsm.dtmf.KeyCandidate;
import simgsm.dtmf.ToneLevels;

/**
 * One receiver's findings on a tone scope's sound. Immutable.
 *
 * @param levels measured last
 * @param digit the key decided last
 * @param isSounding true if that key's tone still sounds
 * @param candidates up to {@link #MOST_CANDIDATES}, the newest last, each with its newest finding
 * @param score of the current experiment; empty counts without one
 */
public record ReceiverTrace(
        ToneLevels levels,
        Optional<DtmfDigit> digit,
        boolean isSounding,
        List<KeyCandidate> candidates,
        ToneScore score) {
    public static final int MOST_CANDIDATES = 12;

    static final ReceiverTrace EMPTY =
            new ReceiverTrace(ToneLevels.SILENCE, Optional.empty(), false, List.of(), ToneScore.NONE);

    public ReceiverTrace {
        candidates = List.copyOf(candidates);
    }
}
