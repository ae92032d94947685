package simgsm.classroom.lesson;

import java.util.List;
import java.util.function.DoublePredicate;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.dtmf.ToneNoise;
import simgsm.dtmf.ToneShape;

/** Measures the limits of the DTMF receiver: the noise, twist and length that lose keys. */
final class ToneLimits {
    private static final List<DtmfKey> TEN_KEYS = DtmfKey.sequence("1234567890");
    private static final int SAMPLES_PER_MILLI = 8;
    private static final int TAPES = 6;
    private static final double MOST_DECIBELS = 20;
    private static final double STEP_DECIBELS = 0.5;
    private static final int LEAST_MILLIS = 10;
    private static final int MOST_MILLIS = 100;
    private static final int PAUSE_MILLIS = 100;

    private ToneLimits() {}

    /** The noise, in dB below the tones, with half of the keys decoded. */
    static double halfHeardDecibels(long seed) {
        return first(-MOST_DECIBELS, MOST_DECIBELS, STEP_DECIBELS, decibels -> {
            int heard = 0;
            for (int tape = 0; tape < TAPES; tape++) {
                heard += heard(ToneShape.STANDARD, decibels, seed + tape);
            }
            return 2 * heard >= TAPES * TEN_KEYS.size();
        });
    }

    /** The largest twist with all keys decoded; the high tone is the louder one. */
    static double mostTwistDecibels() {
        return first(0, MOST_DECIBELS, STEP_DECIBELS, twist -> !allAreHeard(ToneShape.STANDARD.withTwist(twist)))
                - STEP_DECIBELS;
    }

    /** The shortest tones that are all decoded, with pauses of 100 ms. */
    static int shortestMillis() {
        return (int) first(
                LEAST_MILLIS,
                MOST_MILLIS,
                1,
                millis -> allAreHeard(ToneShape.STANDARD
                        .withRamp(0)
                        .withMillis((int) millis, PAUSE_MILLIS)
                        .withRamp(1)));
    }

    /** Bisects for the smallest value, in steps, that passes a test. */
    private static double first(double least, double most, double step, DoublePredicate test) {
        int low = 0;
        int high = (int) Math.round((most - least) / step);
        while (low < high) {
            int middle = (low + high) / 2;
            if (test.test(least + middle * step)) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        return least + low * step;
    }

    private static boolean allAreHeard(ToneShape shape) {
        return heard(shape, Double.POSITIVE_INFINITY, 0) == TEN_KEYS.size();
    }

    private static int heard(ToneShape shape, double decibels, long seed) {
        DtmfGenerator generator = new DtmfGenerator(shape, key -> {});
        TEN_KEYS.forEach(generator::enqueue);
        short[] samples = new short[SAMPLES_PER_MILLI * (shape.toneMillis() + shape.pauseMillis()) * TEN_KEYS.size()];
        generator.read(samples);
        ToneNoise.add(samples, shape, decibels, seed);
        StringBuilder heard = new StringBuilder();
        DtmfReceiver receiver =
                new DtmfReceiver(digit -> heard.append(digit.key().symbol()));
        receiver.accept(samples);
        return Math.min(heard.length(), TEN_KEYS.size());
    }
}
