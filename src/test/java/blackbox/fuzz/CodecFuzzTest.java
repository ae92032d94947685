package blackbox.fuzz;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simgsm.air.Direction;

class CodecFuzzTest {
    private static final long FRAMES = LongRun.frames(30_000);

    @ParameterizedTest
    @MethodSource("blackbox.fuzz.LongRun#seeds")
    void mutatedTrafficIsReadOrRefusedAndNothingElse(long seed) {
        CodecFuzz fuzz = new CodecFuzz(seed);
        while (fuzz.frames() < FRAMES) {
            fuzz.step();
        }
        assertTrue(fuzz.read() > FRAMES / 20 && fuzz.refused() > FRAMES / 4, fuzz.read() + " and " + fuzz.refused());
    }

    @Test
    void theSameSeedSpoilsInTheSameWay() {
        CodecFuzz one = new CodecFuzz(7);
        CodecFuzz other = new CodecFuzz(7);
        for (int i = 0; i < 5_000; i++) {
            one.step();
            other.step();
        }
        assertEquals(one.read(), other.read());
        assertEquals(one.refused(), other.refused());
    }

    @Test
    void whatIsSpoiltStaysUntouchedItself() {
        byte[] octets = {1, 2, 3, 4};
        Mutator mutator = new Mutator(new SplittableRandom(1));
        for (int i = 0; i < 1_000; i++) {
            assertTrue(mutator.mutate(octets, 6).length <= 6);
        }
        assertArrayEquals(new byte[] {1, 2, 3, 4}, octets);
    }

    @Test
    void thereIsTrafficBothWays() {
        for (Direction direction : Direction.values()) {
            long count = RecordedFrames.read().stream()
                    .filter(sample -> sample.direction() == direction)
                    .count();
            assertTrue(count > 30, direction + " " + count);
        }
    }
}
