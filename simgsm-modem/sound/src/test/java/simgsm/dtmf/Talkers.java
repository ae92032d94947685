package simgsm.dtmf;

import java.util.Random;

/**
 * Voices and sounds made another way than in {@link Voices}: a glottis that pulses, with jitter, through a cascade of
 * resonators; whistles; typing; bells; modems.
 */
final class Talkers {
    private Talkers() {}

    private static final class Resonator {
        private double a1;
        private double a2;
        private double gain;
        private double y1;
        private double y2;

        void tune(double hertz, double bandwidth) {
            double radius = Math.exp(-Math.PI * bandwidth / 8000);
            a1 = 2 * radius * Math.cos(2 * Math.PI * hertz / 8000);
            a2 = -radius * radius;
            gain = 1 - a1 - a2;
        }

        double next(double x) {
            double y = gain * x + a1 * y1 + a2 * y2;
            y2 = y1;
            y1 = y;
            return y;
        }
    }

    /** Speech: phrases, pauses, breath, consonants. */
    static double[] talk(Random random, int length) {
        double[] sound = new double[length];
        Resonator[] tract = {new Resonator(), new Resonator(), new Resonator(), new Resonator()};
        double base = 75 * Math.pow(2, 2.2 * random.nextDouble());
        double size = 0.85 + 0.35 * random.nextDouble();
        double breath = 0.01 + 0.05 * random.nextDouble();
        double jitter = 0.002 + 0.015 * random.nextDouble();
        double[] at = {500, 1500, 2500, 3500};
        double[] to = at.clone();
        double pitch = base;
        double pitchTo = base;
        double loud = 0;
        double loudTo = 0;
        double untilPulse = 0;
        double opening = 0;
        double period = 60;
        double before = 0;
        boolean voiced = true;
        int next = 0;
        for (int i = 0; i < length; i++) {
            if (i == next) {
                next += (int) (8000 * (0.04 + 0.22 * random.nextDouble()));
                to[0] = size * (250 + 600 * random.nextDouble());
                to[1] = size * (750 + 1500 * random.nextDouble());
                to[2] = size * (2100 + 900 * random.nextDouble());
                double kind = random.nextDouble();
                voiced = kind < 0.75;
                loudTo = kind > 0.88 ? 0 : voiced ? 0.4 + random.nextDouble() : 0.1 + 0.3 * random.nextDouble();
                pitchTo = base * Math.pow(2, 0.35 * random.nextGaussian());
            }
            pitch += 0.0008 * (pitchTo - pitch);
            loud += 0.006 * (loudTo - loud);
            if (i % 16 == 0) {
                for (int f = 0; f < 4; f++) {
                    at[f] += 0.04 * (to[f] - at[f]);
                    tract[f].tune(Math.min(3900, at[f]), 50 + 40 * f);
                }
            }
            untilPulse--;
            if (untilPulse <= 0) {
                period = 8000 / pitch * (1 + jitter * random.nextGaussian());
                untilPulse += period;
                opening = 0;
            }
            double open = opening++ / (0.6 * period);
            double flow = open < 1 ? open * open * (1 - open) * 6.75 : 0;
            double source = voiced ? flow - before : 0.3 * random.nextGaussian();
            before = flow;
            source += breath * random.nextGaussian();
            double x = source * loud;
            for (Resonator resonator : tract) {
                x = resonator.next(x);
            }
            sound[i] = x;
        }
        return sound;
    }

    /** A voice on one note of which two harmonics lie near a key's tones, in syllables, perhaps with vibrato. */
    static double[] harmonics(Random random, int length) {
        double[] sound = new double[length];
        int at = 0;
        while (at < length) {
            int duration = 400 + random.nextInt(3000);
            DtmfKey key = DtmfKey.values()[random.nextInt(16)];
            int multiple = 1 + random.nextInt(6);
            double hertz = key.rowHertz() / multiple * (1 + 0.01 * random.nextGaussian());
            double vibrato = random.nextBoolean() ? 0 : 0.01 * random.nextDouble();
            double rate = 4 + 3 * random.nextDouble();
            double slope = 0.2 + 1.2 * random.nextDouble();
            double[] gain = new double[64];
            for (int h = 1; h < 64; h++) {
                gain[h] = Math.pow(h, -slope) * Math.pow(10, -random.nextDouble());
            }
            gain[multiple] = 0.5 + 0.5 * random.nextDouble();
            int other = (int) Math.round(key.columnHertz() / hertz);
            gain[Math.min(63, other)] = 0.3 + 0.7 * random.nextDouble();
            double phase = 0;
            double attack = 20 + random.nextInt(300);
            for (int i = at; i < Math.min(length, at + duration); i++) {
                double now = hertz * (1 + vibrato * Math.sin(2 * Math.PI * rate * i / 8000));
                phase += 2 * Math.PI * now / 8000;
                double value = 0;
                for (int h = 1; h < 64 && h * now < 3600; h++) {
                    value += gain[h] * Math.sin(h * phase + h * h);
                }
                double edge = Math.min(1, Math.min(i - at, at + duration - i) / attack);
                sound[i] = edge * value;
            }
            at += duration + random.nextInt(1500);
        }
        return sound;
    }

    /** Whistling: one sine that glides, some breath. */
    static double[] whistle(Random random, int length) {
        double[] sound = new double[length];
        double hertz = 700 + 1200 * random.nextDouble();
        double to = hertz;
        double phase = 0;
        double loud = 0;
        double loudTo = 1;
        for (int i = 0; i < length; i++) {
            if (random.nextInt(2400) == 0) {
                to = 600 + 1400 * random.nextDouble();
                loudTo = random.nextInt(4) == 0 ? 0 : 1;
            }
            hertz += 0.002 * (to - hertz);
            loud += 0.004 * (loudTo - loud);
            phase += 2 * Math.PI * hertz * (1 + 0.008 * Math.sin(i * 0.0045)) / 8000;
            sound[i] = loud * (Math.sin(phase) + 0.08 * Math.sin(2 * phase) + 0.05 * random.nextGaussian());
        }
        return sound;
    }

    /** Keys of a typewriter, knocks, dishes: short bursts that ring at several frequencies. */
    static double[] knocks(Random random, int length) {
        double[] sound = new double[length];
        for (int k = length / 1200; k > 0; k--) {
            int at = random.nextInt(length);
            int lines = 1 + random.nextInt(5);
            for (int l = 0; l < lines; l++) {
                double hertz = 200 + 3000 * random.nextDouble();
                double decay = 20 + 300 * random.nextDouble();
                double loud = random.nextDouble();
                for (int i = at; i < Math.min(length, at + 1600); i++) {
                    sound[i] +=
                            loud * Math.exp(-decay * (i - at) / 8000) * Math.sin(2 * Math.PI * hertz * (i - at) / 8000);
                }
            }
            for (int i = at; i < Math.min(length, at + 40); i++) {
                sound[i] += 0.5 * random.nextGaussian();
            }
        }
        return sound;
    }

    /** Two tones that glide, each through its group. */
    static double[] chirps(Random random, int length) {
        double[] sound = new double[length];
        double low = 650 + 300 * random.nextDouble();
        double high = 1150 + 500 * random.nextDouble();
        double lowRate = (random.nextBoolean() ? 1 : -1) * (500 + 1500 * random.nextDouble());
        double highRate = (random.nextBoolean() ? 1 : -1) * (500 + 2500 * random.nextDouble());
        double a = 0;
        double b = 0;
        for (int i = 0; i < length; i++) {
            low += lowRate / 8000;
            high += highRate / 8000;
            lowRate = low < 600 || low > 1000 ? Math.copySign(lowRate, 800 - low) : lowRate;
            highRate = high < 1100 || high > 1750 ? Math.copySign(highRate, 1400 - high) : highRate;
            a += 2 * Math.PI * low / 8000;
            b += 2 * Math.PI * high / 8000;
            sound[i] = Math.sin(a) + Math.sin(b);
        }
        return sound;
    }

    /** Frequency shift keying at random bits. */
    static double[] modem(Random random, int length, double mark, double space, double bitsPerSecond) {
        double[] sound = new double[length];
        double phase = 0;
        double hertz = mark;
        double next = 0;
        for (int i = 0; i < length; i++) {
            if (i >= next) {
                next += 8000 / bitsPerSecond;
                hertz = random.nextBoolean() ? mark : space;
            }
            phase += 2 * Math.PI * hertz / 8000;
            sound[i] = Math.sin(phase);
        }
        return sound;
    }

    /** Pairs of six tones, one after another: multi-frequency signalling (ITU-T Q.320, Q.441). */
    static double[] pairs(Random random, int length, double[] tones, int toneMillis, int pauseMillis) {
        double[] sound = new double[length];
        for (int at = 0; at < length; at += 8 * (toneMillis + pauseMillis)) {
            int one = random.nextInt(tones.length);
            int other = (one + 1 + random.nextInt(tones.length - 1)) % tones.length;
            for (int i = at; i < Math.min(length, at + 8 * toneMillis); i++) {
                sound[i] =
                        Math.sin(2 * Math.PI * tones[one] * i / 8000) + Math.sin(2 * Math.PI * tones[other] * i / 8000);
            }
        }
        return sound;
    }
}
