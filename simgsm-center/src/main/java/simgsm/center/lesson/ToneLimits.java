package simgsm.center.lesson;

import java.util.List;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.dtmf.ToneNoise;
import simgsm.dtmf.ToneShape;

/** The limits of the DTMF receiver, measured: the noise, the twist and the length at which keys are lost. */
final class ToneLimits {
    private static final List<DtmfKey> TEN_KEYS = DtmfKey.sequence("1234567890");
    private static final int SAMPLES_PER_MILLI = 8;
    private static final int TAPES = 8;
    private static final double MOST_DECIBELS = 20;
    private static final double STEP_DECIBELS = 0.5;
    private static final int MOST_MILLIS = 100;

    private ToneLimits() {}

    /** The noise, in dB below the tones, at which half of the keys are heard. */
    static double halfHeardDecibels(long seed) {
        for (double decibels = MOST_DECIBELS; decibels > -MOST_DECIBELS; decibels -= STEP_DECIBELS) {
            int heard = 0;
            for (int tape = 0; tape < TAPES; tape++) {
                heard += heard(ToneShape.STANDARD, decibels, seed + tape);
            }
            if (2 * heard <= TAPES * TEN_KEYS.size()) {
                return decibels;
            }
        }
        return -MOST_DECIBELS;
    }

    /** The largest twist with which all keys are heard; the high tone is the louder one. */
    static double mostTwistDecibels() {
        double most = 0;
        while (most < MOST_DECIBELS
                && heard(ToneShape.STANDARD.withTwist(most + STEP_DECIBELS), Double.POSITIVE_INFINITY, 0)
                        == TEN_KEYS.size()) {
            most += STEP_DECIBELS;
        }
        return most;
    }

    /** The shortest tones of which all are heard, with pauses of 100 ms. */
    static int shortestMillis() {
        int shortest = MOST_MILLIS;
        while (shortest > 1
                && heard(
                                ToneShape.STANDARD
                                        .withRamp(0)
                                        .withMillis(shortest - 1, 100)
                                        .withRamp(1),
                                Double.POSITIVE_INFINITY,
                                0)
                        == TEN_KEYS.size()) {
            shortest--;
        }
        return shortest;
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
