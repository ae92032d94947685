package simgsm.center.timer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class AllowanceTest {
    private static final long SECOND = 1_000_000_000;

    private static int taken(Allowance allowance, long nowNanos) {
        int count = 0;
        while (allowance.take(nowNanos)) {
            count++;
        }
        return count;
    }

    @Test
    void aBurstMayComeAtOnceAndThenTheEvenPaceHolds() {
        Allowance allowance = new Allowance(10, 25);
        long now = 7 * SECOND;
        assertEquals(25, taken(allowance, now));
        assertFalse(allowance.isLeft(now + SECOND / 10 - 1));
        assertEquals(1, taken(allowance, now + SECOND / 10));
        assertEquals(10, taken(allowance, now + SECOND / 10 + SECOND));
    }

    @Test
    void aRestRestoresTheBurstAndNoMore() {
        Allowance allowance = new Allowance(10, 25);
        taken(allowance, 0);
        assertEquals(25, taken(allowance, 3_600 * SECOND));
    }

    @Test
    void whoeverKeepsToThePaceIsNeverRefused() {
        Allowance allowance = new Allowance(50, 1);
        for (int i = 0; i < 10_000; i++) {
            assertTrue(allowance.take(i * SECOND / 50));
        }
    }

    @Test
    void anAllowanceOfNothingIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> new Allowance(0, 1));
        assertThrows(IllegalArgumentException.class, () -> new Allowance(1, 0));
    }
}
