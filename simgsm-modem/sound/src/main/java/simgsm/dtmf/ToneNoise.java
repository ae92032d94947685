package simgsm.dtmf;

import java.util.Random;
import simgsm.tone.ToneLevel;

/** White noise in the whole band of speech, 0 to 4 kHz, with a power relative to a key's two tones. */
public final class ToneNoise {
    private ToneNoise() {}

    /**
     * Adds noise to samples; sums are clipped to 16 bits.
     *
     * @param shape of the keys in the samples
     * @param snrDecibels the two tones' power over the noise's; infinite for none
     */
    public static void add(short[] samples, ToneShape shape, double snrDecibels, long seed) {
        double row = ToneLevel.amplitude(shape.rowDbm0());
        double column = ToneLevel.amplitude(shape.columnDbm0());
        double power = (row * row + column * column) / 2;
        double deviation = Math.sqrt(power / Math.pow(10, snrDecibels / 10));
        Random random = new Random(seed);
        for (int i = 0; i < samples.length; i++) {
            double value = Math.rint(samples[i] + deviation * random.nextGaussian());
            samples[i] = (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, value));
        }
    }
}
