package simgsm.dtmf;

import java.util.stream.IntStream;
import simgsm.tone.ToneLevel;

/**
 * The first, cheap test, every fourth hop: prominence of one row's and one column's tone in the last 17.5 ms, seven
 * blocks of the {@link GoertzelBank} under a Hann window.
 */
final class ToneGate {
    /** Tones below this level are ignored (Q.24: tones at -55 dBm0 must not be decoded). */
    static final double LEAST_DBM0 = -50;
    /** In both directions; a larger one is no key (later tests are stricter). */
    static final double MOST_TWIST_DB = 13;
    /** Hops from one look to the next. */
    static final int EVERY = 4;

    private static final double FLOOR = Math.pow(ToneLevel.amplitude(LEAST_DBM0), 2);
    private static final double MOST_TWIST = Math.pow(10, MOST_TWIST_DB / 10);
    /** Ratio of all four tones of a group to the strongest; a tone 1.8 % off gives up to 1.24. */
    private static final double MOST_SPREAD = 1.6;

    private static final int GROUP = GoertzelBank.GROUP;

    private static final GoertzelBank.Window LOOK = hann(7);
    /** For bars: leaks 4 to 8 dB less into the neighbours, and takes longer. */
    private static final GoertzelBank.Window LEVELS = hann(8);

    private final double[] perGain = new double[GoertzelBank.TONES];
    private final double[] power = new double[GoertzelBank.TONES];

    ToneGate() {
        for (int k = 0; k < GoertzelBank.TONES; k++) {
            perGain[k] = Math.pow(GoertzelBank.gain(GoertzelBank.HERTZ[k]), -2);
        }
    }

    private static GoertzelBank.Window hann(int blocks) {
        return new GoertzelBank.Window(IntStream.range(0, blocks)
                .mapToDouble(j -> (1 - Math.cos(2 * Math.PI * (j + 0.5) / blocks)) / blocks)
                .toArray());
    }

    /** Tests the blocks up to one. @return ordinal of the prominent key, or -1 */
    int look(GoertzelBank bank, long hop) {
        int row = strongest(bank, hop, 0, LOOK);
        if (power[row] < FLOOR || !standsOut(row)) {
            return -1;
        }
        int column = strongest(bank, hop, GROUP, LOOK);
        double weaker = Math.min(power[row], power[column]);
        boolean found =
                standsOut(column) && weaker > FLOOR && Math.max(power[row], power[column]) < MOST_TWIST * weaker;
        return found ? GROUP * row + column - GROUP : -1;
    }

    /** The newest tones, and their required levels. */
    ToneLevels levels(GoertzelBank bank) {
        double row = Math.sqrt(power[strongest(bank, bank.hops() - 1, 0, LEVELS)]);
        double column = Math.sqrt(power[strongest(bank, bank.hops() - 1, GROUP, LEVELS)]);
        double[] amplitudes = new double[GoertzelBank.TONES];
        for (int k = 0; k < GoertzelBank.TONES; k++) {
            amplitudes[k] = Math.sqrt(power[k]);
        }
        return new ToneLevels(amplitudes, least(column), least(row), this::standsOut);
    }

    /** Required level of a tone by the other group's strongest. */
    private static double least(double other) {
        return Math.max(LEAST_DBM0, ToneLevel.dbm0(other) - MOST_TWIST_DB);
    }

    private boolean standsOut(int tone) {
        int k = tone - tone % GROUP;
        return power[k] + power[k + 1] + power[k + 2] + power[k + 3] < MOST_SPREAD * power[tone];
    }

    /** Measures a group. @return its strongest tone */
    private int strongest(GoertzelBank bank, long hop, int group, GoertzelBank.Window window) {
        int best = group;
        for (int k = group; k < group + GROUP; k++) {
            power[k] = perGain[k] * bank.measure(k, hop, window);
            best = power[k] > power[best] ? k : best;
        }
        return best;
    }
}
