package simgsm.dtmf;

import simgsm.tone.ToneExperiment;

/**
 * A tone scope's immutable data: the last stretch of sound and two receivers' findings. During an experiment the
 * trace shows the disturbed sound.
 */
public final class ToneTrace {
    /** 40 ms at 8 kHz. */
    public static final int SAMPLES = 320;
    /** The trace before any sound. */
    public static final ToneTrace EMPTY = new ToneTrace(
            new short[SAMPLES],
            SoundStretch.EMPTY,
            SoundStretch.EMPTY,
            ToneExperiment.NONE,
            ToneLevels.SILENCE,
            ReceiverTrace.EMPTY,
            ReceiverTrace.EMPTY);

    private final short[] samples;
    private final SoundStretch original;
    private final SoundStretch heard;
    private final ToneExperiment experiment;
    private final ToneLevels originalLevels;
    private final ReceiverTrace modem;
    private final ReceiverTrace classic;

    ToneTrace(
            short[] samples,
            SoundStretch original,
            SoundStretch heard,
            ToneExperiment experiment,
            ToneLevels originalLevels,
            ReceiverTrace modem,
            ReceiverTrace classic) {
        this.samples = samples;
        this.original = original;
        this.heard = heard;
        this.experiment = experiment;
        this.originalLevels = originalLevels;
        this.modem = modem;
        this.classic = classic;
    }

    /** The sound before the experiment. */
    public SoundStretch original() {
        return original;
    }

    /** The sound after the experiment; {@link #sample} returns its last 40 ms. */
    public SoundStretch heard() {
        return heard;
    }

    /** The levels before the experiment. */
    public ToneLevels originalLevels() {
        return originalLevels;
    }

    /** A sample, oldest first. @param index 0 to {@link #SAMPLES} - 1 */
    public short sample(int index) {
        return samples[index];
    }

    /** The experiment applied to the sound. */
    public ToneExperiment experiment() {
        return experiment;
    }

    /** The receiver used by phone and modem. */
    public ReceiverTrace modem() {
        return modem;
    }

    /** The {@link ClassicReceiver} with short blocks. */
    public ReceiverTrace classic() {
        return classic;
    }
}
