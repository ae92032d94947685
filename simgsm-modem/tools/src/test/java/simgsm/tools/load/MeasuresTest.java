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

    /** As a terminal with A-law hears one over towers: A-law, then GSM 06.10, which both ends may also code. */
    @Test
    void everyMarkSurvivesTheSpeechCodecs() {
        for (List<SpeechCodec.Kind> path : List.of(
                List.of(SpeechCodec.Kind.A_LAW),
                List.of(SpeechCodec.Kind.MU_LAW),
                List.of(SpeechCodec.Kind.GSM_FULL_RATE),
                List.of(SpeechCodec.Kind.A_LAW, SpeechCodec.Kind.GSM_FULL_RATE),
                List.of(SpeechCodec.Kind.GSM_FULL_RATE, SpeechCodec.Kind.GSM_FULL_RATE))) {
            List<SpeechCodec> coders = path.stream().map(SpeechCodec.Kind::open).toList();
            List<SpeechCodec> decoders =
                    path.stream().map(SpeechCodec.Kind::open).toList();
            for (int i = 0; i < 10 * SpeechFrameNumber.COUNT; i++) {
                short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
                int mark = i % SpeechFrameNumber.COUNT;
                SpeechFrameNumber.put(frame, mark);
                assertEquals(mark, SpeechFrameNumber.read(passed(frame, coders, decoders)), "by " + path);
            }
        }
    }

    private static short[] passed(short[] frame, List<SpeechCodec> coders, List<SpeechCodec> decoders) {
        short[] heard = frame;
        for (int i = 0; i < coders.size(); i++) {
            heard = decoders.get(i).decode(coders.get(i).encode(heard));
        }
        return heard;
    }

    @Test
    void silenceCarriesNoMark() {
        for (SpeechCodec.Kind kind : SpeechCodec.Kind.values()) {
            SpeechCodec codec = kind.open();
            short[] silence = new short[SpeechCodec.SAMPLES_PER_FRAME];
            assertEquals(
                    SpeechFrameNumber.NONE, SpeechFrameNumber.read(codec.decode(codec.encode(silence))), "" + kind);
        }
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
