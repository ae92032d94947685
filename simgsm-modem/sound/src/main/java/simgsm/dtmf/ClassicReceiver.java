package simgsm.dtmf;

import java.util.Arrays;
import java.util.function.Consumer;
import simgsm.tone.ToneLevel;

/**
 * A textbook receiver: eight Goertzel filters and their second harmonics over blocks of 102 or 205 samples, and a
 * list of tests. Two equal blocks in a row begin a key, two others end it; with 205 samples one of each. Used only
 * for comparison with {@link DtmfReceiver}; the modem does not use it.
 */
public final class ClassicReceiver implements KeyReceiver {
    /** 12.75 ms; two blocks last longer than the 23 ms that Q.24 rejects. */
    public static final int SHORT_BLOCK = 102;
    /** 25.6 ms: the filters' zeros are near the other tones. */
    public static final int LONG_BLOCK = 205;

    /** Tones below -55 dBm0 must be ignored (Q.24); usual receivers require -42. */
    private static final double LEAST_DBM0 = -42;
    /** Q.24, AT&T: high group over low, -8 to 4 dB. */
    private static final double LEAST_TWIST_DB = -8;

    private static final double MOST_TWIST_DB = 4;
    /** Level of a tone over the others of its group. */
    private static final double LEAST_PEAK_DB = 8;
    /**
     * Level of a tone over its second harmonic: voices have overtones. Short blocks do not resolve 2 x 697 Hz and
     * 1336 Hz.
     */
    private static final double LEAST_HARMONIC_DB = 10;
    /** Share of the two tones in all power of the block. */
    private static final double LEAST_SHARE = 0.8;
    /** Twist, peaks, overtones or a second block, share. */
    private static final int TESTS = 4;

    private final Goertzel[] tones = new Goertzel[8];
    private final Goertzel[] harmonics = new Goertzel[8];
    private final int length;
    private final int needed;
    private final DtmfListener listener;
    private final Consumer<KeyCandidate> candidates;
    private final short[] block;
    private int filled;
    private long heard;
    private DtmfKey last;
    private int repeats;
    private DtmfDigit current;
    /** Peaks of the newest block in sample units. */
    private double[] amplitude = new double[8];
    /** The best finding for the key with the strongest tones, or null. */
    private KeyCandidate candidate;

    /**
     * @param candidates receives each block with two strong tones
     * @param blockSamples {@link #SHORT_BLOCK} or {@link #LONG_BLOCK}
     */
    public ClassicReceiver(DtmfListener listener, Consumer<KeyCandidate> candidates, int blockSamples) {
        this.listener = listener;
        this.candidates = candidates;
        length = blockSamples;
        needed = blockSamples < LONG_BLOCK ? 2 : 1;
        block = new short[length];
        for (int i = 0; i < 8; i++) {
            double hertz = i < 4 ? DtmfKey.ROW_HERTZ[i] : DtmfKey.COLUMN_HERTZ[i - 4];
            tones[i] = new Goertzel(hertz);
            harmonics[i] = new Goertzel(2 * hertz);
        }
    }

    @Override
    public void accept(short[] samples, int from, int to) {
        for (int at = from; at < to; ) {
            int n = Math.min(to - at, length - filled);
            System.arraycopy(samples, at, block, filled, n);
            at += n;
            filled += n;
            heard += n;
            if (filled == length) {
                filled = 0;
                decide(look());
            }
        }
    }

    /** The key of the block, or null. */
    private DtmfKey look() {
        amplitude = Arrays.stream(tones).mapToDouble(this::amplitude).toArray();
        int row = strongest(amplitude, 0);
        int column = strongest(amplitude, 4);
        if (ToneLevel.dbm0(Math.min(amplitude[row], amplitude[column])) < LEAST_DBM0) {
            conclude();
            return null;
        }
        DtmfKey key = DtmfKey.at(row, column - 4);
        double twist = decibels(amplitude[column] / amplitude[row]);
        if (twist < LEAST_TWIST_DB || twist > MOST_TWIST_DB) {
            return failed(key, KeyCandidate.Finding.TWIST, 0, twist);
        }
        double peak = Math.min(peak(row), peak(column));
        if (peak < LEAST_PEAK_DB) {
            return failed(key, KeyCandidate.Finding.PEAK, 1, peak);
        }
        double overHarmonic =
                length < LONG_BLOCK ? LEAST_HARMONIC_DB : Math.min(overHarmonic(row), overHarmonic(column));
        if (overHarmonic < LEAST_HARMONIC_DB) {
            return failed(key, KeyCandidate.Finding.OVERTONE, 2, overHarmonic);
        }
        double share = (square(amplitude[row]) + square(amplitude[column])) / 2 / power();
        return share < LEAST_SHARE ? failed(key, KeyCandidate.Finding.SHARE, TESTS - needed, 100 * share) : key;
    }

    /** Mean square of the block. */
    private double power() {
        double power = 0;
        for (short sample : block) {
            power += (double) sample * sample / length;
        }
        return power;
    }

    private double overHarmonic(int tone) {
        return decibels(amplitude[tone] / amplitude(harmonics[tone]));
    }

    private DtmfKey failed(DtmfKey key, KeyCandidate.Finding finding, int passed, double value) {
        consider(key, finding, passed, value);
        return null;
    }

    /** A candidate lasts while the same key's tones are the strongest; its best finding counts. */
    private void consider(DtmfKey key, KeyCandidate.Finding finding, int passed, double value) {
        if (candidate != null && candidate.key() != key) {
            conclude();
        }
        if (candidate == null || passed >= candidate.score() && !candidate.isAccepted()) {
            long from = candidate == null ? heard - length : candidate.fromSample();
            candidate = new KeyCandidate(key, from, heard, finding, passed, TESTS, "", value, false);
            candidates.accept(candidate);
        }
    }

    private void conclude() {
        if (candidate != null) {
            candidates.accept(candidate.over());
            candidate = null;
        }
    }

    private void decide(DtmfKey key) {
        repeats = key == last ? repeats + 1 : 1;
        last = key;
        if (key != null) {
            boolean passed = repeats >= needed;
            consider(
                    key,
                    passed ? KeyCandidate.Finding.PASSED : KeyCandidate.Finding.ONE_BLOCK,
                    passed ? TESTS : TESTS - 1,
                    needed);
        }
        if (repeats < needed) {
            return;
        }
        if (current != null && current.key() != key) {
            end();
        }
        if (key != null && current == null) {
            long start = heard - (long) needed * length;
            current = new DtmfDigit(key, heard, start, heard - start, level(key.row()), level(4 + key.column()), 0, 0);
            listener.keyDecided(current);
        }
    }

    @Override
    public ToneLevels levels() {
        double row = ToneLevel.dbm0(amplitude[strongest(amplitude, 0)]);
        double column = ToneLevel.dbm0(amplitude[strongest(amplitude, 4)]);
        return new ToneLevels(
                amplitude,
                Math.max(LEAST_DBM0, column - MOST_TWIST_DB),
                Math.max(LEAST_DBM0, row + LEAST_TWIST_DB),
                tone -> peak(tone) >= LEAST_PEAK_DB);
    }

    private double level(int tone) {
        return ToneLevel.dbm0(amplitude[tone]);
    }

    private void end() {
        DtmfDigit ended = current;
        current = null;
        listener.keyEnded(ended.withDuration(heard - (long) needed * length - ended.startedAtSample()));
    }

    @Override
    public void finish() {
        conclude();
        if (current != null) {
            end();
        }
    }

    @Override
    public void reset() {
        filled = 0;
        heard = 0;
        last = null;
        repeats = 0;
        current = null;
        candidate = null;
        amplitude = new double[8];
    }

    private double amplitude(Goertzel filter) {
        filter.reset();
        filter.accept(block, 0, length);
        return Math.max(1e-3, filter.amplitude());
    }

    private static int strongest(double[] amplitude, int from) {
        int best = from;
        for (int i = from + 1; i < from + 4; i++) {
            best = amplitude[i] > amplitude[best] ? i : best;
        }
        return best;
    }

    /** A tone's lead over the others of its group in decibels. */
    private double peak(int tone) {
        int from = tone / 4 * 4;
        double other = 1e-3;
        for (int i = from; i < from + 4; i++) {
            other = i == tone ? other : Math.max(other, amplitude[i]);
        }
        return decibels(amplitude[tone] / other);
    }

    private static double square(double x) {
        return x * x;
    }

    private static double decibels(double ratio) {
        return 20 * Math.log10(ratio);
    }
}
