package simgsm.timer;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RecentCountsTest {
    private static final long MINUTE = 60_000_000_000L;

    private final RecentCounts counts = new RecentCounts(3, MINUTE);

    @Test
    void anAuthorIsFullWithTheMostActsUntilTheFirstIsAWindowOld() {
        for (long now = 0; now < 3; now++) {
            assertFalse(counts.isFull("10.0.0.1", now));
            counts.count("10.0.0.1", now);
        }

        assertTrue(counts.isFull("10.0.0.1", 3));
        assertFalse(counts.isFull("10.0.0.2", 3), "another author");
        assertTrue(counts.isFull("10.0.0.1", MINUTE - 1));
        assertFalse(counts.isFull("10.0.0.1", MINUTE));
    }
}
