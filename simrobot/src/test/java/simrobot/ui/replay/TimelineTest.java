package simrobot.ui.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simgsm.draw.Appearance;
import simgsm.draw.Ink;
import simgsm.ui.Theme;
import simrobot.replay.TimelineMarker;
import simrobot.ui.Timeline;
import simrobot.ui.panel.WindowBench;

/** A recording is sought through by mouse and by keyboard; nothing is done to its robots. */
class TimelineTest {
    private static final long SECOND = 1_000_000_000L;
    private static final Timeline TIMELINE = new Timeline(
            0,
            100 * SECOND,
            List.of(
                    new TimelineMarker(10 * SECOND, TimelineMarker.Kind.CALL, "robot", "call robot=robot from=5550100"),
                    new TimelineMarker(20 * SECOND, TimelineMarker.Kind.ORDER, "robot", "order robot=robot"),
                    new TimelineMarker(
                            40 * SECOND, TimelineMarker.Kind.COLLISION, "robot", "status robot=robot value=Collision"),
                    new TimelineMarker(40 * SECOND, TimelineMarker.Kind.REPLY, "robot", "outcome robot=robot")));

    private WindowBench bench;

    @BeforeEach
    void aRecordingThatIsLookedAt() throws Exception {
        Theme.install(Appearance.LIGHT);
        bench = new WindowBench("empty.map", Locale.ENGLISH, "robot");
        bench.timeline = Optional.of(TIMELINE);
        bench.simulation.run(3000);
        bench.show().resize(1100, 760);
    }

    private String last() {
        return bench.acts.get(bench.acts.size() - 1);
    }

    private void key(String id) {
        TimelineBar bar = (TimelineBar) bench.component("timeline");
        bar.getActionMap().get("timeline." + id).actionPerformed(null);
    }

    @Test
    void thePositionIsReported() {
        assertEquals("Recording at 0:00:30.00 of 0:01:40.00", bench.spoken("timeline"));
        assertEquals("0:00:30.00 / 0:01:40.00", bench.spoken("timeline.time"));
    }

    @Test
    void keysGoBySecondsToTheEndsAndFromMarkerToMarker() {
        key("back");
        assertEquals("seek " + 29 * SECOND, last());
        key("far.ahead");
        assertEquals("seek " + 40 * SECOND, last());
        key("next");
        assertEquals("seek " + 40 * SECOND, last());
        key("previous");
        assertEquals("seek " + 20 * SECOND, last());
        key("last");
        assertEquals("seek " + 100 * SECOND, last());
        key("first");
        assertEquals("seek 0", last());
        bench.click("timeline.to.next");
        assertEquals("seek " + 40 * SECOND, last());
    }

    @Test
    void behindTheLastMarkerIsTheEndAndBeforeTheFirstTheBeginning() {
        assertEquals(100 * SECOND, TIMELINE.next(40 * SECOND));
        assertEquals(0, TIMELINE.previous(10 * SECOND));
        assertEquals(100 * SECOND, TIMELINE.clamp(200 * SECOND));
    }

    @Test
    void aClickSeeksAndSticksToAMarkerThatIsNear() {
        TimelineBar bar = (TimelineBar) bench.component("timeline");
        press(bar, bar.getWidth() / 2);
        assertEquals(50, Long.parseLong(last().substring(5)) / 1e9, 0.5);
        int marker = (int) Math.round(12 + 0.2 * (bar.getWidth() - 24)) + 2;
        press(bar, marker);
        assertEquals("seek " + 20 * SECOND, last());
    }

    private static void press(TimelineBar bar, int x) {
        bar.dispatchEvent(new MouseEvent(
                bar, MouseEvent.MOUSE_PRESSED, 0, InputEvent.BUTTON1_DOWN_MASK, x, 20, 1, false, MouseEvent.BUTTON1));
    }

    @Test
    void eachKindOfMarkerIsPaintedInItsColourAndNamedInTheLegend() {
        var image = WindowBench.painted(bench.component("timeline"), 1);
        for (Ink ink : List.of(Ink.ACCENT, Ink.DANGER, Ink.GOOD, Ink.WARNING)) {
            assertTrue(WindowBench.count(image, ink) > 5, ink.toString());
        }
    }

    @Test
    void nothingIsOfferedThatWouldChangeTheRecording() {
        for (String name : List.of("tool.power", "tool.motors", "tool.brake", "tool.world", "tool.record")) {
            assertFalse(bench.component(name).isVisible(), name);
        }
        for (String name : List.of("robot.add", "robot.remove", "robot.restore")) {
            assertTrue(
                    Stream.<Component>iterate(bench.component(name), Objects::nonNull, Component::getParent)
                            .anyMatch(part -> !part.isVisible()),
                    name);
        }
        var robot = bench.simulation.robots().get(0);
        bench.floor().nudge(1, 0, 0);
        assertEquals(0, robot.xMeters());
    }

    @Test
    void theRecordButtonShowsWhetherAFileIsBeingWritten() throws Exception {
        WindowBench live = new WindowBench("empty.map", Locale.ENGLISH, "robot");
        assertEquals("Record the session to a file", live.spoken("tool.record"));
        live.recording = Optional.of(Path.of("a.session"));
        live.show();
        assertEquals("Recording to a.session; press to stop", live.spoken("tool.record"));
        live.click("tool.record");
        assertEquals("record false", live.acts.get(live.acts.size() - 1));
    }
}
