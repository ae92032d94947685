package simrobot.robot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Breadcrumbs, few and very many. */
class TrailTest {
    private static Trail after(int crumbs) {
        Trail trail = new Trail();
        for (int i = 0; i < crumbs; i++) {
            trail.pass(i, -i, i);
        }
        return trail;
    }

    @Test
    void theNewestCrumbsAreKeptInTheirOrderHoweverManyThereWere() {
        for (int crumbs : new int[] {0, 1, 15, 16, 17, 63, 64, 65, 1000, Trail.CAPACITY, Trail.CAPACITY + 1, 9999}) {
            Trail.Crumbs kept = after(crumbs).crumbs();
            assertEquals(Math.min(crumbs, Trail.CAPACITY), kept.size(), crumbs + " crumbs");
            for (int i = 0; i < kept.size(); i++) {
                int expected = crumbs - kept.size() + i;
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
        assertEquals(1, trail.crumbs().size());
        assertEquals(9, trail.crumbs().timesNanos()[0]);
    }
}
