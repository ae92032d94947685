package simgsm.scope;

import java.util.Optional;
import simgsm.dtmf.ClassicReceiver;
import simgsm.dtmf.ToneLevels;
import simgsm.tone.ToneExperiment;
import simgsm.words.WordComparison;

/**
 * A tone scope's immutable data: the last stretch of sound and two receivers' findings. During an experiment the
 * trace shows the disturbed sound.
 *
 * @param original the sound before the experiment
 * @param heard the sound after the experiment
 * @param originalLevels before the experiment
 * @param modem the receiver used by phone and modem
 * @param classic the {@link ClassicReceiver} with short blocks
 * @param word the spoken word that was compared last in the call
 */
public record ToneTrace(
        SoundStretch original,
        SoundStretch heard,
        ToneExperiment experiment,
        ToneLevels originalLevels,
        ReceiverTrace modem,
        ReceiverTrace classic,
        Optional<WordComparison> word) {
    /** 40 ms at 8 kHz. */
    public static final int SAMPLES = 320;
    /** The trace before any sound. */
    public static final ToneTrace EMPTY = new ToneTrace(
            SoundStretch.EMPTY,
            SoundStretch.EMPTY,
            ToneExperiment.NONE,
            ToneLevels.SILENCE,
            ReceiverTrace.EMPTY,
            ReceiverTrace.EMPTY,
            Optional.empty());
}
