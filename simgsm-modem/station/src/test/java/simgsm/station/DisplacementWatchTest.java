package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class DisplacementWatchTest {
    private final DisplacementWatch watch = new DisplacementWatch();

    @Test
    void theFirstEndIsFollowedAtOnceAndFurtherOnesByGrowingPauses() {
        assertEquals(0, watch.linkEnded(Scene.SECOND));
        assertFalse(watch.isNews());
        assertEquals(2 * Scene.SECOND, watch.linkEnded(Scene.SECOND));
        assertTrue(watch.isNews());
        for (int pause : new int[] {4, 8, 16, 32, 60, 60}) {
            assertEquals(pause * Scene.SECOND, watch.linkEnded(60 * Scene.SECOND));
            assertFalse(watch.isNews(), "it is told once");
        }
    }

    @Test
    void aCentreThatWasAwayHasNotDisplacedTheStation() {
        for (int i = 0; i < 5; i++) {
            assertEquals(0, watch.linkEnded(Scene.SECOND));
            watch.reset();
        }
    }

    @Test
    void aRegistrationOfTwoMinutesEndsTheSeries() {
        watch.linkEnded(Scene.SECOND);
        watch.linkEnded(Scene.SECOND);
        assertEquals(0, watch.linkEnded(120 * Scene.SECOND));
        assertEquals(2 * Scene.SECOND, watch.linkEnded(Scene.SECOND));
        assertTrue(watch.isNews());
    }
}
