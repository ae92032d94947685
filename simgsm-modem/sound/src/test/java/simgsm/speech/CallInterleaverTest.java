package simgsm.speech;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Two directions side by side; frames differ by the value of their samples. */
class CallInterleaverTest {
    private final List<Integer> left = new ArrayList<>();
    private final List<Integer> right = new ArrayList<>();
    private final List<Integer> blockLengths = new ArrayList<>();
    private final CallInterleaver tracks = new CallInterleaver(this::take);

    private void take(short[] block) {
        blockLengths.add(block.length);
        for (int i = 0; i < block.length; i += 320) {
            left.add((int) block[i]);
            right.add((int) block[i + 1]);
        }
    }

    private static short[] frame(int value) {
        short[] frame = new short[160];
        Arrays.fill(frame, (short) value);
        return frame;
    }

    private void sent(int from, int to) {
        for (int i = from; i <= to; i++) {
            tracks.sent(frame(i));
        }
    }

    private void received(int from, int to) {
        for (int i = from; i <= to; i++) {
            tracks.received(frame(100 + i));
        }
    }

    @Test
    void whatComesAtTheSameTimeStandsSideBySide() {
        for (int i = 1; i <= 20; i++) {
            sent(i, i);
            received(i, i);
        }
        tracks.end();
        assertEquals(List.of(3200, 3200), blockLengths);
        assertEquals(20, left.size());
        for (int i = 0; i < 20; i++) {
            assertEquals(100 + left.get(i), right.get(i));
        }
    }

    @Test
    void jitterLeavesNoHole() {
        sent(1, 1);
        received(1, 1);
        sent(2, 6);
        received(2, 5);
        sent(7, 7);
        received(6, 9);
        sent(8, 9);
        tracks.end();
        assertEquals(List.of(1, 2, 3, 4, 5, 6, 7, 8, 9), left);
        assertEquals(List.of(101, 102, 103, 104, 105, 106, 107, 108, 109), right);
    }

    @Test
    void whatIsHeardFirstStandsWhereItWasHeard() {
        sent(1, 4);
        received(1, 1);
        sent(5, 5);
        received(2, 2);
        tracks.end();
        assertEquals(List.of(1, 2, 3, 4, 5), left);
        assertEquals(List.of(0, 0, 0, 101, 102), right);
    }

    @Test
    void silenceStandsForWhatDoesNotCome() {
        sent(1, 30);
        tracks.end();
        assertEquals(30, left.size());
        assertEquals(30, right.size());
        assertEquals(0, right.stream().mapToInt(value -> value).sum());
        sent(1, 1);
        received(7, 7);
        tracks.end();
        assertEquals(107, right.get(30), "a new call begins anew");
    }

    @Test
    void aLateStreamGoesOnWithin200Milliseconds() {
        sent(1, 1);
        received(1, 1);
        sent(2, 31);
        received(2, 2);
        sent(32, 32);
        tracks.end();
        assertEquals(102, right.get(21), "the 20 frames beyond the wait are silence");
        assertEquals(32, left.size());
    }

    @Test
    void aPausedDirectionIsSilentOnceTheOtherIsHalfASecondAhead() {
        sent(1, 1);
        received(1, 41);
        sent(2, 2);
        tracks.end();
        assertEquals(41, right.size());
        assertEquals(1, left.get(0));
        assertEquals(2, left.get(16));
    }
}
