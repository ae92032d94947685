package simgsm.timer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import org.junit.jupiter.api.Test;

class CivilTimeTest {
    private static final Instant START = Instant.parse("2026-11-28T12:00:00Z");

    private final CivilTime civil = new CivilTime(START, new Timers());

    @Test
    void followsTheWallClockAndTellsOfJumpsOnce() {
        assertEquals(START.plusNanos(5), civil.at(5));
        assertFalse(civil.isJump(START.plusMillis(999)));
        assertEquals(START.plusMillis(999), civil.now());

        assertTrue(civil.isJump(START.plusSeconds(7200)));
        assertFalse(civil.isJump(START.plusSeconds(7200)));
        assertEquals(START.plusSeconds(7200), civil.local().toInstant());
        assertTrue(civil.isJump(START.minusSeconds(3)), "set back");
    }
}
