package simgsm.scope;

import java.util.SplittableRandom;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.tone.ToneExperiment;

/** Tones of random keys for practice without a call, played to the scope only. Not thread-safe. */
public final class PracticeTone {
    private static final int FRAME_SAMPLES = 160;
    private static final int TONE_MILLIS = 200;
    /** Silence of 300 ms before the tone, and 160 ms of the tone itself. */
    private static final int SILENT_FRAMES = 15;

    private static final int SOUNDING_FRAMES = 8;

    private final SplittableRandom random;
    private final ToneTracer tracer = new ToneTracer();

    public PracticeTone(long seed) {
        random = new SplittableRandom(seed);
    }

    /** A key, and the picture 160 ms after the start of its tone. */
    public record Played(DtmfKey key, ToneTrace trace) {}

    /** Plays the next key. @param experiment applied to the sound */
    public Played next(ToneExperiment experiment) {
        DtmfKey key = DtmfKey.values()[random.nextInt(DtmfKey.values().length)];
        DtmfGenerator generator = new DtmfGenerator();
        tracer.tryOut(experiment);
        for (int i = 0; i < SILENT_FRAMES; i++) {
            tracer.accept(new short[FRAME_SAMPLES]);
        }
        generator.enqueue(key, TONE_MILLIS, TONE_MILLIS);
        for (int i = 0; i < SOUNDING_FRAMES; i++) {
            short[] frame = new short[FRAME_SAMPLES];
            generator.read(frame);
            tracer.accept(frame);
        }
        return new Played(key, tracer.newest());
    }
}
