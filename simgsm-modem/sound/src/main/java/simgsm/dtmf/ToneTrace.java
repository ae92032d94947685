package simgsm.dtmf;

import simgsm.tone.ToneExperiment;

/**
 * What a tone scope shows, immutable: the last stretch of sound, and what two receivers made of it. With an experiment all of
 * it is what is heard of the disturbed sound.
 */
public final class ToneTrace {
    /** 40 ms at 8 kHz. */
    public static final int SAMPLES = 320;
    /** Nothing has sounded yet. */
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

    /** The sound after the experiment, of which {@link #sample} has the last 40 ms. */
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

    /** What was done to the sound. */
    public ToneExperiment experiment() {
        return experiment;
    }

    /** The receiver with which phone and modem decide. */
    public ReceiverTrace modem() {
        return modem;
    }

    /** The {@link ClassicReceiver} with short blocks. */
    public ReceiverTrace classic() {
        return classic;
    }
}
