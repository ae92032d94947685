package simgsm.classroom.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.console.Event;

class LessonSessionTest {
    private final List<String> told = new ArrayList<>();

    private final LessonSession.Watcher watcher = new LessonSession.Watcher() {
        @Override
        public void refused(String refused, String why) {
            told.add(refused + ": " + why);
        }

        @Override
        public void idle(String seconds) {
            told.add("idle " + seconds);
        }
    };

    @Test
    void theRefusalOfAnActionIsReported() {
        LessonSession.report(Event.of("error").with("text", "typed on the console"), "", watcher);
        LessonSession.report(Event.of("error").with("text", "there is no call"), "play", watcher);
        assertEquals(List.of("play: there is no call"), told);
    }

    @Test
    void aRobotThatHangsUpForWantOfKeysIsReported() {
        LessonSession.report(Event.of("call-idle").with("robot", "robot").with("seconds", 60), "", watcher);
        assertEquals(List.of("idle 60"), told);
    }

    @Test
    void theFirstAtPortIsThatOfTheProgram() {
        assertEquals(4711, LessonSession.atPort(Event.of("ready").with("at", "4711,4712")));
        assertEquals(0, LessonSession.atPort(Event.of("ready")));
        assertEquals(0, LessonSession.atPort(Event.of("ready").with("at", "")));
    }
}
