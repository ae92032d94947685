package simgsm.dtmf;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import simgsm.tone.ToneLevel;

/**
 * A recording in the making, with what a receiver ought to hear in it: digits are laid down one after another, then the
 * line spoils them. Samples are doubles on the scale of 16 bits; levels are in dBm0.
 */
final class Tape {
    static final int RATE = 8000;

    final Random random;
    final StringBuilder expected = new StringBuilder();
    /** Sample at which each expected digit's tone starts. */
    final List<Integer> starts = new ArrayList<>();

    final List<Integer> ends = new ArrayList<>();

    /** Samples were lost or doubled, so that starts hold no longer. */
    boolean slipped;

    double[] sound = new double[0];
    private int length;

    // What the next digits sound like.
    double rowDbm0 = -10;
    double columnDbm0 = -10;
    double rowError;
    double columnError;
    double toneMillis = 80;
    double pauseMillis = 80;
    double rampMillis;
    /** Below 0: no interruption. */
    double dropOutMillis = -1;
    /** What is left of the tone in an interruption. */
    double dropOutRemains;

    Tape(long seed) {
        random = new Random(seed);
    }

    int length() {
        return length;
    }

    double uniform(double from, double to) {
        return from + (to - from) * random.nextDouble();
    }

    private void grow(int samples) {
        if (length + samples > sound.length) {
            sound = java.util.Arrays.copyOf(sound, 2 * (length + samples));
        }
        length += samples;
    }

    Tape silence(double millis) {
        grow((int) Math.round(millis * RATE / 1000));
        return this;
    }

    /** Lays down digits that must be heard, each followed by its pause. */
    Tape digits(String keys) {
        for (char symbol : keys.toCharArray()) {
            digit(DtmfKey.of(symbol), true);
        }
        return this;
    }

    /** Lays down what sounds like digits but must not be taken for any. */
    Tape decoys(String keys) {
        for (char symbol : keys.toCharArray()) {
            digit(DtmfKey.of(symbol), false);
        }
        return this;
    }

    private void digit(DtmfKey key, boolean counts) {
        if (counts) {
            expected.append(key.symbol());
            starts.add(length);
        }
        int at = length;
        silence(toneMillis);
        if (counts) {
            ends.add(length);
        }
        tone(at, length, key.rowHertz() * (1 + rowError), rowDbm0);
        tone(at, length, key.columnHertz() * (1 + columnError), columnDbm0);
        if (dropOutMillis >= 0) {
            int hole = (int) Math.round(dropOutMillis * 8);
            int room = length - at - hole;
            int from = at + room / 4 + random.nextInt(Math.max(1, room / 2));
            for (int i = from; i < from + hole; i++) {
                sound[i] *= dropOutRemains;
            }
        }
        silence(pauseMillis);
    }

    private void tone(int from, int to, double hertz, double dbm0) {
        double amplitude = ToneLevel.amplitude(dbm0);
        double phase = uniform(0, 2 * Math.PI);
        double step = 2 * Math.PI * hertz / RATE;
        double ramp = rampMillis * 8;
        for (int i = from; i < to; i++) {
            double edge = Math.min(i - from, to - 1 - i) + 0.5;
            double envelope = edge >= ramp ? 1 : 0.5 - 0.5 * Math.cos(Math.PI * edge / ramp);
            sound[i] += envelope * amplitude * Math.sin(phase + step * (i - from));
        }
    }

    /** A sine under the whole recording. */
    Tape hum(double hertz, double dbm0) {
        double ramp = rampMillis;
        rampMillis = 0;
        tone(0, length, hertz, dbm0);
        rampMillis = ramp;
        return this;
    }

    /** White noise under the whole recording, by its power. */
    Tape noise(double dbm0) {
        double sigma = ToneLevel.amplitude(dbm0) / Math.sqrt(2);
        for (int i = 0; i < length; i++) {
            sound[i] += sigma * random.nextGaussian();
        }
        return this;
    }

    /** White noise this number of decibels below the power of both tones together. */
    Tape noiseBelowTones(double decibels) {
        return noise(10 * Math.log10(Math.pow(10, rowDbm0 / 10) + Math.pow(10, columnDbm0 / 10)) - decibels);
    }

    Tape add(double[] other) {
        for (int i = 0; i < Math.min(length, other.length); i++) {
            sound[i] += other[i];
        }
        return this;
    }

    Tape offset(double value) {
        for (int i = 0; i < length; i++) {
            sound[i] += value;
        }
        return this;
    }

    Tape gain(double decibels) {
        double factor = Math.pow(10, decibels / 20);
        for (int i = 0; i < length; i++) {
            sound[i] *= factor;
        }
        return this;
    }

    Tape clip(double peak) {
        for (int i = 0; i < length; i++) {
            sound[i] = Math.max(-peak, Math.min(peak, sound[i]));
        }
        return this;
    }

    Tape impulses(double perSecond, double peak) {
        int count = (int) (perSecond * length / RATE);
        for (int k = 0; k < count; k++) {
            int at = random.nextInt(length);
            double height = (random.nextBoolean() ? 1 : -1) * peak * uniform(0.5, 1);
            for (int i = at; i < Math.min(length, at + 1 + random.nextInt(4)); i++) {
                sound[i] += height;
                height = -0.6 * height;
            }
        }
        return this;
    }

    Tape echo(double millis, double decibelsDown) {
        int delay = (int) Math.round(millis * 8);
        double factor = Math.pow(10, -decibelsDown / 20);
        for (int i = length - 1; i >= delay; i--) {
            sound[i] += factor * sound[i - delay];
        }
        return this;
    }

    /** Loses or doubles single samples, as two clocks that drift apart do. */
    Tape slips(double everyMillis) {
        slipped = true;
        double[] out = new double[sound.length + 1000];
        int at = 0;
        int next = (int) (everyMillis * 8);
        for (int i = 0; i < length; i++) {
            if (i == next) {
                next += (int) (everyMillis * 8 * uniform(0.5, 1.5));
                if (random.nextBoolean()) {
                    continue;
                }
                out[at++] = sound[i];
            }
            out[at++] = sound[i];
        }
        sound = out;
        length = at;
        return this;
    }

    /** Loses whole 20 ms frames. */
    Tape frameLoss(double share) {
        for (int i = 0; i + 160 <= length; i += 160) {
            if (random.nextDouble() < share) {
                java.util.Arrays.fill(sound, i, i + 160, 0);
            }
        }
        return this;
    }

    /** Beginning at once and ending at once: nothing before the first tone, nothing behind the last. */
    Tape trim(int from, int to) {
        System.arraycopy(sound, from, sound, 0, to - from);
        java.util.Arrays.fill(sound, to - from, sound.length, 0);
        length = to - from;
        starts.replaceAll(start -> start - from);
        ends.replaceAll(end -> end - from);
        return this;
    }

    /** A second-order section, bilinear transform; q = 0.707 for Butterworth. */
    Tape filter(boolean highPass, double hertz, double q) {
        double w = 2 * Math.PI * hertz / RATE;
        double alpha = Math.sin(w) / (2 * q);
        double a0 = 1 + alpha;
        double sign = highPass ? -1 : 1;
        double b0 = (1 - sign * Math.cos(w)) / 2 / a0;
        double b1 = sign * 2 * b0;
        double a1 = -2 * Math.cos(w) / a0;
        double a2 = (1 - alpha) / a0;
        double x1 = 0;
        double x2 = 0;
        double y1 = 0;
        double y2 = 0;
        for (int i = 0; i < length; i++) {
            double x = sound[i];
            double y = b0 * x + b1 * x1 + b0 * x2 - a1 * y1 - a2 * y2;
            x2 = x1;
            x1 = x;
            y2 = y1;
            y1 = y;
            sound[i] = y;
        }
        return this;
    }

    /** A telephone line's band, 300 to 3400 Hz, fourth order either way. */
    Tape telephoneBand() {
        return filter(true, 300, 0.54)
                .filter(true, 300, 1.31)
                .filter(false, 3400, 0.54)
                .filter(false, 3400, 1.31);
    }

    /** Harmonics and products of both tones: second and third order, so much for a sample at full scale. */
    Tape bend(double second, double third) {
        for (int i = 0; i < length; i++) {
            double x = sound[i] / 32768;
            sound[i] = 32768 * (x + second * x * x + third * x * x * x);
        }
        return this;
    }

    /** The level varies by this number of decibels to either side. */
    Tape flutter(double hertz, double decibels) {
        double phase = uniform(0, 2 * Math.PI);
        for (int i = 0; i < length; i++) {
            sound[i] *= Math.pow(10, decibels / 20 * Math.sin(phase + 2 * Math.PI * hertz * i / RATE));
        }
        return this;
    }

    /** A room: many weak echoes that die away. */
    Tape room(double tailMillis, double decibelsDown) {
        double[] out = sound.clone();
        for (int k = 0; k < 12; k++) {
            double millis = uniform(2, tailMillis);
            int delay = (int) (8 * millis);
            double factor =
                    (random.nextBoolean() ? 1 : -1) * Math.pow(10, -(decibelsDown + 20 * millis / tailMillis) / 20);
            for (int i = delay; i < length; i++) {
                out[i] += factor * sound[i - delay];
            }
        }
        sound = out;
        return this;
    }

    /** At random places this number of samples is lost or repeated. */
    Tape jumps(double everyMillis, int samples) {
        slipped = true;
        double[] out = new double[2 * sound.length];
        int at = 0;
        int next = (int) (everyMillis * 8 * uniform(0.5, 1.5));
        for (int i = 0; i < length; i++) {
            if (i >= next) {
                next += (int) (everyMillis * 8 * uniform(0.5, 1.5));
                i += random.nextBoolean() ? samples : -Math.min(samples, i);
            }
            if (i < length && at < out.length) {
                out[at++] = sound[i];
            }
        }
        sound = out;
        length = at;
        return this;
    }

    /** Bursts of noise, as of hands on a microphone. */
    Tape crackle(double perSecond, double millis, double dbm0) {
        double sigma = ToneLevel.amplitude(dbm0) / Math.sqrt(2);
        for (int k = (int) (perSecond * length / RATE); k > 0; k--) {
            int at = random.nextInt(length);
            for (int i = at; i < Math.min(length, at + 8 * millis); i++) {
                sound[i] += sigma * random.nextGaussian();
            }
        }
        return this;
    }

    /** Rounds to this number of bits, at most 16. */
    Tape coarse(int bits) {
        double step = 1 << 16 - bits;
        for (int i = 0; i < length; i++) {
            sound[i] = step * Math.rint(sound[i] / step);
        }
        return this;
    }

    short[] samples() {
        short[] samples = new short[length];
        for (int i = 0; i < length; i++) {
            samples[i] = (short) Math.max(-32768, Math.min(32767, Math.rint(sound[i])));
        }
        return samples;
    }

    Tape replace(short[] samples) {
        length = Math.min(length, samples.length);
        for (int i = 0; i < length; i++) {
            sound[i] = samples[i];
        }
        return this;
    }
}
