package simgsm.timer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RateLimitTest {
    private static final long SECOND = 1_000_000_000;

    private static int taken(RateLimit allowance, long nowNanos) {
        int count = 0;
        while (allowance.take(nowNanos)) {
            count++;
        }
        return count;
    }

    @Test
    void aBurstMayComeAtOnceAndThenTheEvenPaceHolds() {
        RateLimit allowance = new RateLimit(10, 25);
        long now = 7 * SECOND;
        assertEquals(25, taken(allowance, now));
        assertFalse(allowance.isLeft(now + SECOND / 10 - 1));
        assertEquals(1, taken(allowance, now + SECOND / 10));
        assertEquals(10, taken(allowance, now + SECOND / 10 + SECOND));
    }

    @Test
    void aRestRestoresTheBurstAndNoMore() {
        RateLimit allowance = new RateLimit(10, 25);
        taken(allowance, 0);
        assertEquals(25, taken(allowance, 3_600 * SECOND));
    }

    @Test
    void whoeverKeepsToThePaceIsNeverRefused() {
        RateLimit allowance = new RateLimit(50, 1);
        for (int i = 0; i < 10_000; i++) {
            assertTrue(allowance.take(i * SECOND / 50));
        }
    }

    @Test
    void anAllowanceOfNothingIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new RateLimit(0, 1));
        assertThrows(IllegalArgumentException.class, () -> new RateLimit(1, 0));
    }
}
