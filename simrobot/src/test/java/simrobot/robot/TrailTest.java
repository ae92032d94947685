package simrobot.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Breadcrumbs, few and very many. */
class TrailTest {
    private static Trail after(int points) {
        Trail trail = new Trail();
        for (int i = 0; i < points; i++) {
            trail.pass(i, -i, i);
        }
        return trail;
    }

    @Test
    void theNewestCrumbsAreKeptInTheirOrderHoweverManyThereWere() {
        for (int points : new int[] {0, 1, 15, 16, 17, 63, 64, 65, 1000, Trail.CAPACITY, Trail.CAPACITY + 1, 9999}) {
            Trail.Points kept = after(points).points();
            assertEquals(Math.min(points, Trail.CAPACITY), kept.size(), points + " points");
            for (int i = 0; i < kept.size(); i++) {
                int expected = points - kept.size() + i;
                assertEquals(expected, kept.timesNanos()[i]);
                assertEquals(expected, kept.xy()[2 * i]);
                assertEquals(-expected, kept.xy()[2 * i + 1]);
            }
        }
    }

    @Test
    void aClearedTrailBeginsAnew() {
        Trail trail = after(4321);
        trail.clear();
        trail.pass(7, 8, 9);
        assertEquals(1, trail.points().size());
        assertEquals(9, trail.points().timesNanos()[0]);
    }
}
