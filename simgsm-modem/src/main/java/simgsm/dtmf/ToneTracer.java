package simgsm.dtmf;

import java.util.Arrays;
import java.util.Optional;

/**
 * Collects what a tone scope shows from the sound that passes: feed it frames, ask for the newest {@link ToneTrace}. It
 * listens with a receiver of its own, so the scope measures what it draws. Owned by one thread.
 */
public final class ToneTracer {
    /** Levels are measured over the last 25.6 ms: the frequencies, 73 Hz apart and more, are told apart clearly. */
    private static final int LEVEL_WINDOW = 205;

    private static final int FREQUENCIES = 8;

    private final short[] samples = new short[ToneTrace.SAMPLES];
    private final Goertzel[] filters = new Goertzel[FREQUENCIES];
    private final DtmfReceiver receiver = new DtmfReceiver(new Ear());
    private DtmfDigit digit;
    private boolean sounding;
    private boolean silent = true;
    private ToneTrace newest = ToneTrace.EMPTY;

    public ToneTracer() {
        for (int i = 0; i < 4; i++) {
            filters[i] = new Goertzel(DtmfKey.ROW_HERTZ[i]);
            filters[4 + i] = new Goertzel(DtmfKey.COLUMN_HERTZ[i]);
        }
    }

    /** The next stretch of sound, at most {@link ToneTrace#SAMPLES} long. @return whether the picture has changed */
    public boolean accept(short[] frame) {
        boolean wasSilent = silent;
        receiver.accept(frame);
        int kept = samples.length - frame.length;
        System.arraycopy(samples, frame.length, samples, 0, kept);
        System.arraycopy(frame, 0, samples, kept, frame.length);
        silent = isSilent();
        if (silent && wasSilent) {
            return false;
        }
        newest = new ToneTrace(samples.clone(), levels(), Optional.ofNullable(digit), sounding);
        return true;
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

    /** As new. */
    public void reset() {
        receiver.reset();
        Arrays.fill(samples, (short) 0);
        digit = null;
        sounding = false;
        silent = true;
        newest = ToneTrace.EMPTY;
    }

    private final class Ear implements DtmfListener {
        @Override
        public void keyDecided(DtmfDigit decided) {
            digit = decided;
            sounding = true;
        }

        @Override
        public void keyEnded(DtmfDigit ended) {
            digit = ended;
            sounding = false;
        }
    }
}
