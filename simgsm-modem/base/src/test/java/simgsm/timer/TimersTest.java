package simgsm.timer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class TimersTest {
    private final Timers timers = new Timers();
    private final List<String> expired = new ArrayList<>();

    private Timer start(long delay, String name) {
        return timers.start(delay, () -> expired.add(name + "@" + timers.nowNanos()));
    }

    @Test
    void timersExpireInTheOrderOfTheirDeadlinesEachAtItsOwnMoment() {
        start(30, "c");
        start(10, "a");
        start(20, "b");
        timers.advance(25);
        assertEquals(List.of("a@10", "b@20"), expired);
        assertEquals(25, timers.nowNanos());
        timers.advance(100);
        assertEquals(List.of("a@10", "b@20", "c@30"), expired);
    }

    @Test
    void equalDeadlinesExpireInTheOrderOfStarting() {
        start(10, "first");
        start(10, "second");
        start(10, "third");
        timers.advance(10);
        assertEquals(List.of("first@10", "second@10", "third@10"), expired);
    }

    @Test
    void aCancelledTimerNeverExpiresAndCancellingTwiceIsHarmless() {
        Timer timer = start(10, "a");
        timers.cancel(timer);
        timers.cancel(timer);
        timers.cancel(null);
        timers.advance(20);
        assertTrue(expired.isEmpty());
        assertFalse(timer.isRunning());
        assertEquals(OptionalLong.empty(), timers.nextDeadlineNanos());
    }

    @Test
    void aStartIsToldOnlyIfTheTimerIsTheFirstToExpire() {
        timers.onEarlier(() -> expired.add("next " + timers.nextDeadlineNanos().getAsLong()));
        start(30, "c");
        start(40, "d");
        start(30, "e");
        Timer first = start(10, "a");
        timers.cancel(first);
        start(20, "b");
        assertEquals(List.of("next 30", "next 10", "next 20"), expired);
    }

    @Test
    void aTimerStartedByAnExpiringOneCountsFromThatMoment() {
        timers.start(10, () -> start(5, "later"));
        timers.advance(100);
        assertEquals(List.of("later@15"), expired);
    }

    @Test
    void timeNeverGoesBack() {
        timers.advance(50);
        timers.advance(20);
        assertEquals(50, timers.nowNanos());
    }

    @Test
    void theHeapStaysRightUnderManyRandomStartsAndCancellations() {
        SplittableRandom random = new SplittableRandom(7);
        List<Timer> running = new ArrayList<>();
        List<Long> moments = new ArrayList<>();
        for (int i = 0; i < 5_000; i++) {
            running.add(timers.start(random.nextInt(1_000), () -> moments.add(timers.nowNanos())));
            if (i % 3 == 0) {
                timers.cancel(running.remove(random.nextInt(running.size())));
            }
        }
        int left = timers.size();
        timers.advance(2_000);
        assertEquals(left, moments.size());
        assertEquals(moments.stream().sorted().toList(), moments);
        assertEquals(5_000 - 1_667, left);
    }
}
