package simgsm.dtmf;

import java.util.Random;
import simgsm.tone.ToneLevel;

/** Sounds that are no digits but might be taken for some: voices, music, the tones of the network. */
final class Voices {
    private static final double[][] VOWELS = {
        {730, 1090, 2440}, {270, 2290, 3010}, {300, 870, 2240}, {530, 1840, 2480}, {570, 840, 2410}, {440, 1020, 2240},
        {640, 1190, 2390}, {490, 1350, 1690}, {660, 1720, 2410}, {390, 1990, 2550}, {700, 1200, 2600}, {800, 1400, 2900}
    };

    private Voices() {}

    /** Scales to that mean power. */
    static double[] atLevel(double[] sound, double dbm0) {
        double power = 1e-9;
        for (double sample : sound) {
            power += sample * sample / sound.length;
        }
        double factor = ToneLevel.amplitude(dbm0) / Math.sqrt(2 * power);
        for (int i = 0; i < sound.length; i++) {
            sound[i] *= factor;
        }
        return sound;
    }

    /** A voice: a train of harmonics with gliding pitch, through gliding formants, in syllables, with hisses between. */
    static double[] speech(Random random, int length) {
        double[] sound = new double[length];
        double base = 80 * Math.pow(2, 2.3 * random.nextDouble());
        double jitter = random.nextDouble() < 0.3 ? 0 : 0.01;
        boolean sung = random.nextDouble() < 0.25;
        double phase = 0;
        double[] formant = VOWELS[random.nextInt(VOWELS.length)].clone();
        double[] target = formant.clone();
        double pitch = base;
        double pitchTarget = base;
        double loud = 0;
        double loudTarget = 1;
        int next = 0;
        boolean hiss = false;
        double tract = 0.85 + 0.3 * random.nextDouble();
        double previous = 0;
        double width = 60 + 60 * random.nextDouble();
        double tilt = 0.5 + random.nextDouble();
        double[] gains = new double[64];
        for (int i = 0; i < length; i++) {
            if (i >= next) {
                next = i + (int) ((sung ? 0.2 + 0.6 * random.nextDouble() : 0.05 + 0.25 * random.nextDouble()) * 8000);
                target = VOWELS[random.nextInt(VOWELS.length)];
                pitchTarget =
                        base * Math.pow(2, sung ? (random.nextInt(13) - 6) / 12.0 : 0.5 * random.nextGaussian() * 0.6);
                loudTarget = random.nextDouble() < 0.25 ? 0 : 0.3 + random.nextDouble();
                hiss = random.nextDouble() < 0.15;
            }
            double glide = sung ? 0.004 : 0.0015;
            pitch += glide * (pitchTarget - pitch);
            loud += 0.01 * (loudTarget - loud);
            for (int f = 0; f < 3; f++) {
                formant[f] += 0.002 * (target[f] * tract - formant[f]);
            }
            if (hiss) {
                double white = random.nextGaussian();
                sound[i] = 0.15 * loud * (white - previous);
                previous = white;
                continue;
            }
            double now = pitch * (1 + jitter * Math.sin(i * 0.0041) * 0.5);
            phase += 2 * Math.PI * now / 8000;
            if (i % 40 == 0) {
                for (int h = 1; h < 64; h++) {
                    double hertz = h * now;
                    double gain = 0;
                    for (int f = 0; f < 3; f++) {
                        double x = (hertz - formant[f]) / (width * (1 + 0.3 * f));
                        gain += 1 / (1 + x * x) / (1 + f);
                    }
                    gains[h] = hertz > 3600 ? 0 : gain * Math.pow(h, -tilt);
                }
            }
            double value = 0;
            double sine = Math.sin(phase);
            double cosine = 2 * Math.cos(phase);
            double older = 0;
            double old = sine;
            for (int h = 1; h < 64 && h * now < 3700; h++) {
                value += gains[h] * old;
                double newer = cosine * old - older;
                older = old;
                old = newer;
            }
            sound[i] = loud * value;
        }
        return sound;
    }

    /** Chords of notes in equal temperament, struck and dying away, each with its own mixture of overtones. */
    static double[] music(Random random, int length) {
        double[] sound = new double[length];
        double beat = (0.1 + 0.4 * random.nextDouble()) * 8000;
        double tuning = 440 * Math.pow(2, (random.nextDouble() - 0.5) / 20);
        int overtones = 1 + random.nextInt(8);
        double slope = 0.3 + 2 * random.nextDouble();
        double decay = random.nextBoolean() ? 0 : 8 * random.nextDouble();
        int voices = 1 + random.nextInt(4);
        for (double at = 0; at < length; at += beat * (1 + random.nextInt(3))) {
            for (int v = 0; v < voices; v++) {
                double hertz = tuning * Math.pow(2, (random.nextInt(40) - 20) / 12.0);
                int duration = (int) (beat * (1 + random.nextInt(4)));
                double loud = 0.3 + random.nextDouble();
                for (int h = 1; h <= overtones && h * hertz < 3700; h++) {
                    double phase = 2 * Math.PI * random.nextDouble();
                    double step = 2 * Math.PI * h * hertz / 8000;
                    double gain = loud * Math.pow(h, -slope);
                    for (int i = (int) at; i < Math.min(length, (int) at + duration); i++) {
                        double t = i - at;
                        double edge = Math.min(1, Math.min(t, duration - t) / 80);
                        sound[i] += gain * edge * Math.exp(-decay * t / 8000) * Math.sin(phase + step * t);
                    }
                }
            }
        }
        return sound;
    }

    /** Tones of the network, on and off. @param cadence milliseconds on, off, on, off ... */
    static double[] cadence(Random random, int length, double[] hertz, int... cadence) {
        double[] sound = new double[length];
        double[] phase = new double[hertz.length];
        for (int k = 0; k < phase.length; k++) {
            phase[k] = 2 * Math.PI * random.nextDouble();
        }
        int at = 0;
        for (int part = 0; at < length; part++) {
            int until = Math.min(length, at + 8 * cadence[part % cadence.length]);
            for (int i = at; i < until && part % 2 == 0; i++) {
                for (int k = 0; k < hertz.length; k++) {
                    sound[i] += Math.sin(phase[k] + 2 * Math.PI * hertz[k] * i / 8000);
                }
            }
            at = until;
        }
        return sound;
    }

    /** A siren or whistle gliding up and down. */
    static double[] siren(Random random, int length) {
        double[] sound = new double[length];
        double low = 300 + 500 * random.nextDouble();
        double high = low * (1.3 + 2 * random.nextDouble());
        double rate = 0.2 + 5 * random.nextDouble();
        int overtones = 1 + random.nextInt(4);
        double phase = 0;
        for (int i = 0; i < length; i++) {
            phase += 2 * Math.PI * (low + (high - low) * (0.5 + 0.5 * Math.sin(2 * Math.PI * rate * i / 8000))) / 8000;
            for (int h = 1; h <= overtones; h++) {
                sound[i] += Math.sin(h * phase) / h;
            }
        }
        return sound;
    }

    /** Noise through one resonance: wind, traffic, a crowd. */
    static double[] colouredNoise(Random random, int length) {
        double[] sound = new double[length];
        double hertz = 100 + 1500 * random.nextDouble();
        double radius = 0.5 + 0.49 * random.nextDouble();
        double a1 = 2 * radius * Math.cos(2 * Math.PI * hertz / 8000);
        double a2 = -radius * radius;
        for (int i = 2; i < length; i++) {
            sound[i] = random.nextGaussian() + a1 * sound[i - 1] + a2 * sound[i - 2];
        }
        return sound;
    }
}
