package simgsm.center.net;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class ViewTest {
    private final View view = new View();
    private int looks;

    private void watch() {
        view.watch(100, exchange -> looks++);
    }

    @Test
    void whoDoesNotWatchCostsNothing() {
        view.changed();
        assertEquals(Long.MAX_VALUE, view.dueNanos());
    }

    @Test
    void changesAreSeenAtOnceButNotMoreOftenThanOnceAPeriod() {
        watch();
        view.lookIfDue(0, null);
        assertEquals(1, looks);
        view.changed();
        view.lookIfDue(50, null);
        assertEquals(1, looks);
        assertEquals(100, view.dueNanos(), "the last change is not forgotten");
        view.lookIfDue(100, null);
        assertEquals(2, looks);
    }

    @Test
    void withoutChangesNobodyLooks() {
        watch();
        view.lookIfDue(0, null);
        view.lookIfDue(1_000, null);
        assertEquals(1, looks);
        assertEquals(Long.MAX_VALUE, view.dueNanos());
    }
}
