package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Random;
import java.util.function.DoublePredicate;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;

/**
 * The receiver's acceptance bench, in the manner of the tapes that makers of receivers use (decode check, bandwidth, twist,
 * dynamic range, guard time, noise, talk-off), written from ITU-T Q.24 alone. Prints a table; the limits asserted are
 * Q.24's. Sounds are made here, not by the generator under the same roof.
 */
@TestMethodOrder(MethodOrderer.MethodName.class)
class DtmfAcceptanceTest {
    private static final int RATE = 8000;
    private static final int PULSES = 10;
    private static final double FULL_SCALE_DBM0 = 3.14;

    private final Random random = new Random(763);

    /** One key's pulses as asked for; counts how many of them are heard, and nothing else. */
    private final class Pulses {
        double rowError;
        double columnError;
        double rowDbm0 = -10;
        double columnDbm0 = -10;
        double toneMillis = 50;
        double pauseMillis = 50;
        double noiseDbm0 = -90;

        int heard(DtmfKey key) {
            int period = samples(toneMillis + pauseMillis);
            double[] sound = new double[400 + PULSES * period];
            for (int pulse = 0; pulse < PULSES; pulse++) {
                int at = 400 + pulse * period + random.nextInt(20);
                sine(sound, at, key.rowHertz() * (1 + rowError), rowDbm0);
                sine(sound, at, key.columnHertz() * (1 + columnError), columnDbm0);
            }
            short[] line = new short[sound.length];
            double sigma = amplitude(noiseDbm0) / Math.sqrt(2);
            for (int i = 0; i < line.length; i++) {
                line[i] =
                        (short) Math.max(-32768, Math.min(32767, Math.rint(sound[i] + sigma * random.nextGaussian())));
            }
            int[] count = {0, 0};
            DtmfReceiver receiver = new DtmfReceiver(digit -> count[digit.key() == key ? 0 : 1]++);
            receiver.accept(line);
            receiver.finish();
            assertEquals(0, count[1], "another key than " + key);
            return count[0];
        }

        private void sine(double[] sound, int at, double hertz, double dbm0) {
            double phase = 2 * Math.PI * random.nextDouble();
            int end = Math.min(sound.length, at + samples(toneMillis));
            for (int i = at; i < end; i++) {
                sound[i] += amplitude(dbm0) * Math.sin(phase + 2 * Math.PI * hertz * (i - at) / RATE);
            }
        }
    }

    private static double amplitude(double dbm0) {
        return 32768 * Math.pow(10, (dbm0 - FULL_SCALE_DBM0) / 20);
    }

    private static int samples(double millis) {
        return (int) Math.round(millis * RATE / 1000);
    }

    private static boolean allHeard(Pulses pulses, DtmfKey key) {
        return pulses.heard(key) == PULSES;
    }

    /** The last value on the way from the first at which all is well. */
    private static double reach(double from, double step, double most, DoublePredicate well) {
        double reached = Double.NaN;
        for (double value = from; step > 0 ? value <= most : value >= most; value += step) {
            if (!well.test(value)) {
                return reached;
            }
            reached = value;
        }
        return reached;
    }

    private static void row(String what, String asked, String measured) {
        System.out.printf("  %-34s %-22s %s%n", what, asked, measured);
    }

    @Test
    void test1EveryKeyIsDecoded() {
        System.out.println("DTMF receiver, acceptance bench");
        int heard = 0;
        for (DtmfKey key : DtmfKey.values()) {
            heard += new Pulses().heard(key);
        }
        row("decode check, 16 keys x 10", "all", heard + " of 160");
        assertEquals(160, heard);
    }

    @Test
    void test2BandwidthIsBetween1point5And3point5Percent() {
        for (DtmfKey key : new DtmfKey[] {DtmfKey.ONE, DtmfKey.FIVE, DtmfKey.NINE, DtmfKey.D}) {
            double[] reached = new double[4];
            for (int side = 0; side < 4; side++) {
                double sign = side % 2 == 0 ? -0.001 : 0.001;
                boolean ofRow = side < 2;
                reached[side] = 0.1
                        * reach(0, 1, 60, steps -> {
                            Pulses pulses = new Pulses();
                            pulses.rowError = ofRow ? sign * steps : 0;
                            pulses.columnError = ofRow ? 0 : sign * steps;
                            return allHeard(pulses, key);
                        });
                Pulses far = new Pulses();
                far.rowError = ofRow ? 30 * sign : 0;
                far.columnError = ofRow ? 0 : 30 * sign;
                assertEquals(0, far.heard(key), key + " 3 % off");
            }
            row(
                    "bandwidth of " + key.symbol() + ", row and column",
                    "1.5 (1.8) .. 3.0 %",
                    String.format("-%.1f +%.1f %%, -%.1f +%.1f %%", reached[0], reached[1], reached[2], reached[3]));
            assertTrue(Arrays.stream(reached).min().orElse(0) >= 1.8, Arrays.toString(reached));
        }
    }

    @Test
    void test3TwistOf8DecibelsIsBorneAnd15Not() {
        for (int sign : new int[] {-1, 1}) {
            double worst = 99;
            for (DtmfKey key : DtmfKey.values()) {
                worst = Math.min(worst, reach(0, 0.5, 20, twist -> allHeard(twisted(sign * twist), key)));
                assertEquals(0, twisted(sign * 15).heard(key), key + " twisted by 15 dB");
            }
            row(sign > 0 ? "twist, high group louder" : "twist, low group louder", "8 .. 15 dB", worst + " dB");
            assertTrue(worst >= 8, worst + " dB");
        }
    }

    private Pulses twisted(double decibels) {
        Pulses pulses = new Pulses();
        pulses.rowDbm0 = decibels > 0 ? -3 - decibels : -3;
        pulses.columnDbm0 = decibels > 0 ? -3 : -3 + decibels;
        return pulses;
    }

    @Test
    void test4DynamicRange() {
        double lowest = -99;
        for (DtmfKey key : DtmfKey.values()) {
            lowest = Math.max(lowest, reach(0, -1, -60, dbm0 -> allHeard(level(dbm0), key)));
            assertEquals(0, level(-55).heard(key), key + " at -55 dBm0");
        }
        row("dynamic range", "0 .. -36, never -55", "0 .. " + lowest + " dBm0");
        assertTrue(lowest <= -36, lowest + " dBm0");
    }

    private Pulses level(double dbm0) {
        Pulses pulses = new Pulses();
        pulses.rowDbm0 = dbm0;
        pulses.columnDbm0 = dbm0;
        return pulses;
    }

    @Test
    void test5GuardTimes() {
        double tone = reach(50, -1, 15, millis -> allHeard(timed(millis, 50), DtmfKey.FIVE));
        double pause = reach(50, -1, 10, millis -> allHeard(timed(50, millis), DtmfKey.FIVE));
        row("shortest tone", "23 .. 40 (35) ms", tone + " ms");
        row("shortest pause", "at most 40 (30) ms", pause + " ms");
        assertTrue(tone > 23 && tone <= 35, tone + " ms");
        assertTrue(pause <= 30, pause + " ms");
        for (DtmfKey key : DtmfKey.values()) {
            assertEquals(0, timed(22, 50).heard(key), key + " for 22 ms");
        }
    }

    private Pulses timed(double toneMillis, double pauseMillis) {
        Pulses pulses = new Pulses();
        pulses.toneMillis = toneMillis;
        pulses.pauseMillis = pauseMillis;
        return pulses;
    }

    @Test
    void test6Noise() {
        for (int snr : new int[] {12, 6, 3, 0}) {
            int heard = 0;
            for (DtmfKey key : DtmfKey.values()) {
                for (int round = 0; round < 4; round++) {
                    heard += noisy(snr).heard(key);
                }
            }
            row("signal to noise " + snr + " dB, 640 pulses", snr < 6 ? "-" : "all", heard + " heard");
            assertTrue(heard >= (snr >= 6 ? 639 : snr == 3 ? 630 : 580), heard + " of 640 at " + snr + " dB");
        }
    }

    private Pulses noisy(double snr) {
        Pulses pulses = new Pulses();
        pulses.noiseDbm0 = -7 - snr;
        return pulses;
    }

    /** Ten minutes of voices: pulses through resonances that wander, in syllables, at -15 dBm0. */
    @Test
    void test7TalkOff() {
        int[] heard = {0};
        DtmfReceiver receiver = new DtmfReceiver(digit -> heard[0]++);
        for (int minute = 0; minute < 10; minute++) {
            receiver.accept(voice(60 * RATE));
        }
        row("talk-off, 10 min of synthetic voices", "0", heard[0] + " keys");
        assertEquals(0, heard[0]);
    }

    private short[] voice(int length) {
        double[] sound = new double[length];
        double[][] memory = new double[3][2];
        double[] hertz = {600, 1400, 2500};
        double[] aim = hertz.clone();
        double pitch = 90 + 170 * random.nextDouble();
        double next = 0;
        double loud = 0;
        double aimLoud = 0;
        double squares = 0;
        for (int i = 0; i < length; i++) {
            if (i % 1200 == 0) {
                aim = new double[] {
                    300 + 500 * random.nextDouble(), 900 + 1300 * random.nextDouble(), 2200 + 800 * random.nextDouble()
                };
                aimLoud = random.nextInt(4) == 0 ? 0 : 0.3 + random.nextDouble();
                pitch *= Math.pow(2, 0.1 * random.nextGaussian());
                pitch = Math.max(80, Math.min(300, pitch));
            }
            loud += 0.004 * (aimLoud - loud);
            double x = random.nextGaussian() * 0.01;
            if (i >= next) {
                next += RATE / pitch * (1 + 0.01 * random.nextGaussian());
                x += 1;
            }
            x *= loud;
            double y = 0;
            for (int f = 0; f < 3; f++) {
                hertz[f] += 0.002 * (aim[f] - hertz[f]);
                double radius = Math.exp(-Math.PI * (60 + 30 * f) / RATE);
                double now = x
                        + 2 * radius * Math.cos(2 * Math.PI * hertz[f] / RATE) * memory[f][0]
                        - radius * radius * memory[f][1];
                memory[f][1] = memory[f][0];
                memory[f][0] = now;
                y += now / (1 + f);
            }
            sound[i] = y;
            squares += y * y;
        }
        double gain = amplitude(-15) / Math.sqrt(2 * squares / length);
        short[] samples = new short[length];
        for (int i = 0; i < length; i++) {
            samples[i] = (short) Math.max(-32768, Math.min(32767, Math.rint(gain * sound[i])));
        }
        return samples;
    }

    /** The claim is about frames without keys, and holds from the first one on: 100 s of noise, no object. */
    @Test
    void test8ListeningAllocatesNothing() {
        short[] noise = new short[RATE];
        for (int i = 0; i < noise.length; i++) {
            noise[i] = (short) (3000 * random.nextGaussian());
        }
        DtmfReceiver receiver = new DtmfReceiver(digit -> {});
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long self = Thread.currentThread().getId();
        receiver.accept(noise);
        threads.getThreadAllocatedBytes(self);
        long before = threads.getThreadAllocatedBytes(self);
        for (int second = 0; second < 100; second++) {
            receiver.accept(noise);
        }
        long bytes = threads.getThreadAllocatedBytes(self) - before;
        row("allocation, 100 s in frames", "none", bytes + " bytes");
        assertTrue(bytes < 1000, bytes + " bytes in 40 000 frames");
    }
}
