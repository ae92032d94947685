package simgsm.dtmf;

import java.util.List;
import java.util.Optional;

/**
 * What one receiver made of the sound that a tone scope shows. Immutable.
 *
 * @param levels as the receiver measured them last
 * @param digit the key that was decided last
 * @param isSounding whether that key's tone still sounds
 * @param candidates up to {@link #MOST_CANDIDATES}, the newest last, each with its newest finding
 * @param score how the experiment went since it was set; empty counts without one
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
