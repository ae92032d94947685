package simgsm.dtmf;

import java.util.Arrays;
import java.util.Optional;

/**
 * Collects what a tone scope shows from the sound that passes: feed it frames, ask for the newest {@link ToneTrace}. It
 * listens with a receiver of its own, so the scope measures what it draws, and an experiment does not disturb other receivers. Owned
 * by one thread.
 */
public final class ToneTracer {
    /** Levels are measured over the last 25.6 ms: the frequencies, 73 Hz apart and more, are resolved. */
    private static final int LEVEL_WINDOW = 205;

    private static final int FREQUENCIES = 8;

    private final short[] samples = new short[ToneTrace.SAMPLES];
    private final Goertzel[] filters = new Goertzel[FREQUENCIES];
    private final DtmfReceiver receiver = new DtmfReceiver(new Ear());
    private final Disturber disturber = new Disturber();
    private final ScoreKeeper scores = new ScoreKeeper();
    /** Hears the sound as it is while there is an experiment to be judged. */
    private final DtmfReceiver reference;

    private ToneExperiment experiment = ToneExperiment.NONE;
    private long samplesPassed;
    private DtmfDigit digit;
    private boolean sounding;
    private boolean silent = true;
    private ToneTrace newest = ToneTrace.EMPTY;

    public ToneTracer() {
        for (int i = 0; i < 4; i++) {
            filters[i] = new Goertzel(DtmfKey.ROW_HERTZ[i]);
            filters[4 + i] = new Goertzel(DtmfKey.COLUMN_HERTZ[i]);
        }
        reference = new DtmfReceiver(heard -> scores.truth(heard.key(), samplesPassed));
    }

    /** From now on the sound is disturbed so before it is looked at. The score begins anew. */
    public void tryOut(ToneExperiment newExperiment) {
        if (!newExperiment.equals(experiment)) {
            experiment = newExperiment;
            disturber.set(newExperiment);
            reference.reset();
            scores.clear();
            publish();
        }
    }

    /** The next stretch of sound, at most 280 samples long. @return whether the picture has changed */
    public boolean accept(short[] frame) {
        boolean tries = !experiment.equals(ToneExperiment.NONE);
        short[] heard = tries ? disturber.disturbed(frame) : frame;
        samplesPassed += frame.length;
        ToneScore before = scores.score();
        if (tries) {
            reference.accept(frame);
        }
        receiver.accept(heard);
        scores.timePassed(samplesPassed);
        boolean changed = look(heard) || !before.equals(scores.score());
        if (changed) {
            publish();
        }
        return changed;
    }

    /** @return whether there is anything new to be seen */
    private boolean look(short[] heard) {
        boolean wasSilent = silent;
        int kept = samples.length - heard.length;
        System.arraycopy(samples, heard.length, samples, 0, kept);
        System.arraycopy(heard, 0, samples, kept, heard.length);
        silent = isSilent();
        return !(silent && wasSilent);
    }

    /** No sound comes for now: the picture is quiet, and the last key stays. */
    public void rest() {
        Arrays.fill(samples, (short) 0);
        receiver.finish();
        sounding = false;
        silent = true;
        publish();
    }

    private void publish() {
        newest = new ToneTrace(
                samples.clone(), levels(), Optional.ofNullable(digit), sounding, experiment, scores.score());
    }

    private boolean isSilent() {
        for (short sample : samples) {
            // A-law's quietest steps are silence, too.
            if (Math.abs(sample) > 16) {
                return false;
            }
        }
        return !sounding;
    }

    private double[] levels() {
        double[] levels = new double[FREQUENCIES];
        for (int i = 0; i < FREQUENCIES; i++) {
            filters[i].reset();
            filters[i].accept(samples, samples.length - LEVEL_WINDOW, samples.length);
            double amplitude = filters[i].amplitude();
            levels[i] =
                    amplitude < 1 ? ToneTrace.FLOOR_DBM0 : Math.max(ToneTrace.FLOOR_DBM0, ToneLevel.dbm0(amplitude));
        }
        return levels;
    }

    public ToneTrace newest() {
        return newest;
    }

    /** As new, but for the experiment. */
    public void reset() {
        receiver.reset();
        reference.reset();
        disturber.clear();
        scores.clear();
        Arrays.fill(samples, (short) 0);
        digit = null;
        sounding = false;
        silent = true;
        if (experiment.equals(ToneExperiment.NONE)) {
            newest = ToneTrace.EMPTY;
        } else {
            publish();
        }
    }

    private final class Ear implements DtmfListener {
        @Override
        public void keyDecided(DtmfDigit decided) {
            digit = decided;
            sounding = true;
            if (!experiment.equals(ToneExperiment.NONE)) {
                scores.attempt(decided.key(), samplesPassed);
            }
        }

        @Override
        public void keyEnded(DtmfDigit ended) {
            digit = ended;
            sounding = false;
        }
    }
}
