package simgsm.tools.load;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import simgsm.speech.SpeechCodec;

class MeasuresTest {
    @Test
    void halfOfTheDelaysAreWithinTheMedian() {
        DelayHistogram delays = new DelayHistogram();
        for (int millis = 1; millis <= 100; millis++) {
            delays.add(millis * 1_000_000L);
        }
        assertEquals(50, delays.millis(0.5), 0.02);
        assertEquals(99, delays.millis(0.99), 0.02);
        assertEquals(100, delays.millis(1), 0.02);
        assertEquals(100, delays.count());
    }

    @Test
    void aDelayBeyondTheScaleCountsAsTheLongest() {
        DelayHistogram delays = new DelayHistogram();
        delays.add(Long.MAX_VALUE);
        assertEquals(20_000, delays.millis(0.5), 0.02);
    }

    @Test
    void nothingMeasuredIsNoDelay() {
        assertEquals(0, new DelayHistogram().millis(0.5));
    }

    @Test
    void everyMarkSurvivesTheSpeechCodec() {
        SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
        short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
        for (int mark : List.of(0, 1, 0x5555, 0xaaaa, 0x1234, SpeechFrameNumber.LARGEST)) {
            SpeechFrameNumber.put(frame, mark);
            assertEquals(mark, SpeechFrameNumber.read(codec.decode(codec.encode(frame))));
        }
    }

    @Test
    void silenceCarriesNoMark() {
        SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
        short[] silence = new short[SpeechCodec.SAMPLES_PER_FRAME];
        assertEquals(SpeechFrameNumber.NONE, SpeechFrameNumber.read(codec.decode(codec.encode(silence))));
    }

    @Test
    void aWindowKeepsSoManyTasksUnderWayAndNoMore() {
        List<Integer> begun = new ArrayList<>();
        TaskWindow window = new TaskWindow(5, 2, begun::add);
        window.start();
        assertEquals(List.of(0, 1), begun);
        window.ended(1, true);
        assertEquals(List.of(0, 1, 2), begun);
        window.ended(1, true);
        window.ended(4, true);
        assertEquals(List.of(0, 1, 2), begun, "1 was over already and 4 has not begun");
    }

    @Test
    void waitingEndsWithTheLastTask() throws InterruptedException {
        List<Integer> begun = new ArrayList<>();
        TaskWindow window = new TaskWindow(3, 3, begun::add);
        window.start();
        window.ended(2, true);
        window.ended(0, false);
        window.ended(1, true);
        window.await(Long.MAX_VALUE / 4);
        assertEquals(2, window.done());
        assertEquals(3, window.count());
    }

    @Test
    void tasksThatEndWhileTheyBeginAreBegunOneAfterTheOther() {
        AtomicReference<TaskWindow> window = new AtomicReference<>();
        AtomicInteger depth = new AtomicInteger();
        AtomicInteger deepest = new AtomicInteger();
        window.set(new TaskWindow(2_000, 50, task -> {
            deepest.accumulateAndGet(depth.incrementAndGet(), Math::max);
            window.get().ended(task, true);
            depth.decrementAndGet();
        }));
        window.get().start();
        assertEquals(2_000, window.get().done());
        assertEquals(1, deepest.get(), "a task began within another one: the stack grows with each");
    }

    @Test
    void waitingGivesUpWhenNothingGetsOn() throws InterruptedException {
        TaskWindow window = new TaskWindow(1, 1, task -> {});
        window.start();
        window.await(1);
        assertEquals(0, window.done());
        assertEquals(0, window.perSecond());
    }
}
