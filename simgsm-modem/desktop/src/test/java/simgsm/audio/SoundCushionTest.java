package simgsm.audio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The cushion before a device that plays what it has, a millisecond after the other, and silence when it has nothing. */
class SoundCushionTest {
    private static final long FRAME_MICROS = 20_000;

    /** Starts at a time before 0, as System.nanoTime may. */
    private static final long START_MICROS = -1_000_000;

    private SoundCushion cushion = new SoundCushion(START_MICROS * 1000);
    /** The device's own time for a second of ours. */
    private double deviceRate = 1;

    private double deviceMicros;
    private double endMicros;
    /** When each of the sounding frames began to be played, by the device's clock. */
    private final List<Double> begins = new ArrayList<>();

    private int written;

    private void frame(long micros, int value) {
        short[] frame = new short[160];
        Arrays.fill(frame, (short) value);
        short[] samples = cushion.accept(frame, (START_MICROS + micros) * 1000);
        deviceMicros = micros * deviceRate;
        written += samples.length;
        endMicros = Math.max(deviceMicros, endMicros) + samples.length * 125;
        if (samples.length > 0 && Math.abs(value) > 16) {
            begins.add(endMicros - FRAME_MICROS);
        }
    }

    /** @return how late its first frame was played */
    private double key(long micros, int frames, int... lateMillis) {
        begins.clear();
        for (int i = 0; i < frames; i++) {
            frame(micros + i * FRAME_MICROS + 1000L * lateMillis[i % lateMillis.length], 5000);
        }
        return begins.get(0) - micros * deviceRate;
    }

    private long holes() {
        return java.util.stream.IntStream.range(1, begins.size())
                .filter(i -> begins.get(i) - begins.get(i - 1) > FRAME_MICROS)
                .count();
    }

    /** The end of the queue, after the device has played a key. */
    @Test
    void anEmptyFrameAfterASoundIsNothing() {
        key(0, 5, 0);
        assertEquals(0, cushion.accept(new short[0], (START_MICROS + 1_000_000) * 1000).length);
    }

    @Test
    void aKeyBegins40MillisecondsAfterItWasPressedAndHasNoHoleThoughItsFramesComeLate() {
        assertEquals(40_000, key(0, 25, 0, 39, 5, 20, 38));
        assertEquals(25, begins.size());
        assertEquals(0, holes());
    }

    @Test
    void aFrameThatIsLaterThanTheCushionLeavesOneHoleAndACushionForTheRest() {
        int[] lateMillis = new int[25];
        Arrays.fill(lateMillis, 3, 25, 70);
        lateMillis[6] = 100;
        key(0, 25, lateMillis);
        assertEquals(1, holes());
    }

    @Test
    void pausesOfAnyLengthStayAsLongAsTheyWere() {
        long at = 0;
        for (int pauseFrames = 1; pauseFrames < 12; pauseFrames++) {
            assertEquals(40_000, key(at, 3, 0));
            at += 3 * FRAME_MICROS;
            for (int i = 0; i < pauseFrames; i++, at += FRAME_MICROS) {
                frame(at, i % 2 * 16);
            }
        }
    }

    /** 200 ppm, more than the crystals of two computers differ, and an hour of keys. */
    @Test
    void clocksThatDriftApartMakeNoKeyLaterNorHoleOverAnHour() {
        for (double rate : new double[] {1 - 2e-4, 1 + 2e-4}) {
            deviceRate = rate;
            for (long micros = 0; micros < 3_600_000_000L; micros += 50 * FRAME_MICROS) {
                assertEquals(40_000, key(micros, 25, 0), 20);
                assertEquals(0, holes());
                for (int i = 25; i < 50; i++) {
                    frame(micros + i * FRAME_MICROS, 8);
                }
            }
            cushion = new SoundCushion(START_MICROS * 1000);
            endMicros = 0;
        }
    }

    @Test
    void aBurstAfterAStallIsCutWhereItWouldBePlayedTooLate() {
        for (int i = 0; i < 10; i++) {
            frame(0, 5000);
        }
        assertTrue(endMicros <= 1000 * SoundCushion.MOST_MILLIS + FRAME_MICROS, "" + endMicros);
    }

    @Test
    void silenceIsNotWritten() {
        for (int i = 0; i < 50; i++) {
            frame(i * FRAME_MICROS, 8);
        }
        assertEquals(0, written);
    }
}
