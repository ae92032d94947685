package simgsm.tone;

import java.util.Arrays;
import java.util.SplittableRandom;

/**
 * Applies a {@link ToneExperiment} to sound. Frequencies are shifted by playing faster or slower, which changes the
 * length by as much; noise is relative to the loudest recent sound; the codec is last. The result is reproducible.
 * Owned by one thread.
 */
public final class Disturber {
    /** Two tones of -10 dBm0: reference of the noise until a sound louder than silence. */
    private static final double USUAL_POWER = square(ToneLevel.amplitude(-10));
    /** Below -40 dBm0 is silence. */
    private static final double SILENCE_POWER = square(ToneLevel.amplitude(-40)) / 2;
    /** Per frame of 20 ms: half a decibel a second. */
    private static final double DECAY = Math.pow(10, -0.05 / 50);

    private static final int ARM = 8;
    private static final int PHASES = 256;
    private static final float[][] TAPS = taps();

    private ToneExperiment experiment = ToneExperiment.NONE;
    private final Recoder recoder = new Recoder();
    private SplittableRandom random = new SplittableRandom(1);
    private double power = USUAL_POWER;
    private boolean heard;
    /** The last undisturbed samples, and the ones received since. */
    private float[] past = new float[2 * ARM];
    /** Index of the next sample in {@link #past}. */
    private double position = ARM;

    public Disturber() {}

    /** Effective from the next frame. */
    public void set(ToneExperiment newExperiment) {
        experiment = newExperiment;
        recoder.set(newExperiment.codec());
    }

    /** Clears all state for a new sound. */
    public void clear() {
        recoder.clear();
        random = new SplittableRandom(1);
        power = USUAL_POWER;
        heard = false;
        past = new float[2 * ARM];
        position = ARM;
    }

    /** @return the disturbed frame; shorter or longer if frequencies are shifted */
    public short[] disturbed(short[] frame) {
        follow(frame);
        double[] sound = experiment.shiftPercent() == 0 ? unshifted(frame) : shifted(frame);
        double noise = experiment.hasNoise() ? Math.sqrt(power * Math.pow(10, -experiment.snrDecibels() / 10)) : 0;
        short[] result = new short[sound.length];
        for (int i = 0; i < result.length; i++) {
            double value = noise == 0 ? sound[i] : sound[i] + noise * random.nextGaussian();
            result[i] = (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, Math.rint(value)));
        }
        return recoder.recoded(result);
    }

    private void follow(short[] frame) {
        double sum = 0;
        for (short sample : frame) {
            sum += (double) sample * sample;
        }
        double now = frame.length == 0 ? 0 : sum / frame.length;
        if (now > SILENCE_POWER && !heard) {
            heard = true;
            power = now;
        }
        power = heard ? Math.max(now, power * DECAY) : power;
        power = Math.max(power, SILENCE_POWER);
    }

    private static double[] unshifted(short[] frame) {
        double[] sound = new double[frame.length];
        Arrays.setAll(sound, i -> frame[i]);
        return sound;
    }

    private double[] shifted(short[] frame) {
        int kept = past.length;
        past = Arrays.copyOf(past, kept + frame.length);
        for (int i = 0; i < frame.length; i++) {
            past[kept + i] = frame[i];
        }
        double step = 1 + experiment.shiftPercent() / 100;
        double[] result = new double[(int) (frame.length / step) + 2];
        int n = 0;
        for (; position + ARM < past.length && n < result.length; position += step) {
            result[n++] = at(position);
        }
        int used = Math.max(0, Math.min(past.length - 2 * ARM, (int) position - ARM));
        past = Arrays.copyOfRange(past, used, past.length);
        position -= used;
        return Arrays.copyOf(result, n);
    }

    private double at(double place) {
        int whole = (int) place;
        float[] taps = TAPS[(int) Math.round((place - whole) * PHASES)];
        double sum = 0;
        for (int i = 0; i < 2 * ARM; i++) {
            sum += taps[i] * past[whole - ARM + 1 + i];
        }
        return sum;
    }

    /** A sinc under a Hann window for each phase; its error below 1.8 kHz is about -60 dB. */
    private static float[][] taps() {
        float[][] all = new float[PHASES + 1][2 * ARM];
        for (int phase = 0; phase <= PHASES; phase++) {
            for (int i = 0; i < 2 * ARM; i++) {
                double distance = i - (ARM - 1) - phase / (double) PHASES;
                double sinc = distance == 0 ? 1 : Math.sin(Math.PI * distance) / (Math.PI * distance);
                double window = Math.abs(distance) >= ARM ? 0 : square(Math.cos(Math.PI * distance / (2 * ARM)));
                all[phase][i] = (float) (sinc * window);
            }
        }
        return all;
    }

    private static double square(double x) {
        return x * x;
    }
}
