package simgsm.center.net;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class RateLimitedObserverTest {
    private final RateLimitedObserver observer = new RateLimitedObserver();
    private int shown;

    private void watch() {
        observer.set(100, exchange -> shown++);
    }

    @Test
    void withoutAnObserverNothingIsDue() {
        observer.changed();
        assertEquals(Long.MAX_VALUE, observer.dueNanos());
    }

    @Test
    void changesAreShownAtOnceButAtMostOncePerPeriod() {
        watch();
        observer.showIfDue(0, null);
        assertEquals(1, shown);
        observer.changed();
        observer.showIfDue(50, null);
        assertEquals(1, shown);
        assertEquals(100, observer.dueNanos(), "the last change is not forgotten");
        observer.showIfDue(100, null);
        assertEquals(2, shown);
    }

    @Test
    void withoutChangesNothingIsShown() {
        watch();
        observer.showIfDue(0, null);
        observer.showIfDue(1_000, null);
        assertEquals(1, shown);
        assertEquals(Long.MAX_VALUE, observer.dueNanos());
    }
}
