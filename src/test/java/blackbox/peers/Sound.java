package blackbox.peers;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;

/** Samples at 8 kHz to which keys, noise and speech are added, with the keys that a receiver should hear. */
final class Sound {
    /** A raw file as sox names it. */
    static final String RAW = "-t raw -r 8000 -c 1 -b 16 -e signed";

    /** A full-scale sine is at 3.14 dBm0 (ITU-T G.711). */
    private static final double ZERO_DBM0 = 32768 * Math.pow(10, -3.14 / 20);

    private static final String KEYS = "123A456B789C*0#D";
    private static final double[] ROWS = {697, 770, 852, 941};
    private static final double[] COLUMNS = {1209, 1336, 1477, 1633};

    final Random random;
    final StringBuilder keys = new StringBuilder();
    private double[] samples = new double[8000];
    private int length;

    Sound(long seed) {
        random = new Random(seed);
    }

    static double amplitude(double dbm0) {
        return ZERO_DBM0 * Math.pow(10, dbm0 / 20);
    }

    int length() {
        return length;
    }

    void silence(int millis) {
        length += millis * 8;
        samples = length > samples.length ? Arrays.copyOf(samples, 2 * length) : samples;
    }

    /** A key at random, both tones at -10 dBm0, exact and with random phases. @return its first sample */
    int key(int toneMillis, int pauseMillis) {
        int key = random.nextInt(16);
        int from = length;
        silence(toneMillis + pauseMillis);
        addSine(ROWS[key / 4], -10, from, from + 8 * toneMillis);
        addSine(COLUMNS[key % 4], -10, from, from + 8 * toneMillis);
        keys.append(KEYS.charAt(key));
        return from;
    }

    void addSine(double hertz, double dbm0, int from, int to) {
        double phase = random.nextDouble() * 2 * Math.PI;
        double step = 2 * Math.PI * hertz / 8000;
        for (int i = from; i < to; i++) {
            samples[i] += amplitude(dbm0) * Math.sin(phase + step * (i - from));
        }
    }

    /** White noise whose power from 0 to 4 kHz is that of a sine of this level. */
    void addNoise(double dbm0, int from, int to) {
        double sigma = amplitude(dbm0) / Math.sqrt(2);
        for (int i = from; i < to; i++) {
            samples[i] += sigma * random.nextGaussian();
        }
    }

    void limit(double dbm0, int from, int to) {
        for (int i = from; i < to; i++) {
            samples[i] = Math.signum(samples[i]) * amplitude(dbm0);
        }
    }

    /** What has sounded so far once more, later and weaker. */
    void echo(int millis, double decibels) {
        double[] before = samples.clone();
        for (int i = 8 * millis; i < length; i++) {
            samples[i] += before[i - 8 * millis] * Math.pow(10, -decibels / 20);
        }
    }

    /** Speech from a place at random, scaled so that its level where it is not silent is that of a sine of dbm0. */
    void addSpeech(short[] speech, double dbm0, int from, int to) {
        double sum = 0;
        int loud = 1;
        for (short sample : speech) {
            if (Math.abs(sample) > 200) {
                sum += sample * sample;
                loud++;
            }
        }
        double gain = amplitude(dbm0) / Math.sqrt(2 * sum / loud);
        int start = random.nextInt(speech.length - (to - from));
        for (int i = from; i < to; i++) {
            samples[i] += gain * speech[start + i - from];
        }
    }

    void add(short[] others) {
        for (int i = 0; i < Math.min(length, others.length); i++) {
            samples[i] += others[i];
        }
    }

    Path write(Path file) throws Exception {
        ByteBuffer octets = ByteBuffer.allocate(2 * length).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < length; i++) {
            octets.putShort((short) Math.max(-32768, Math.min(32767, Math.rint(samples[i]))));
        }
        return Files.write(file, octets.array());
    }

    static short[] read(Path file) throws Exception {
        byte[] octets = Files.readAllBytes(file);
        short[] samples = new short[octets.length / 2];
        ByteBuffer.wrap(octets).order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().get(samples);
        return samples;
    }
}
