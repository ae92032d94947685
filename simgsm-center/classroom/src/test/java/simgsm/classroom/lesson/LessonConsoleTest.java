package simgsm.classroom.lesson;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import simgsm.console.Event;
import simgsm.lesson.LessonLibrary;
import simgsm.lesson.LessonRun;

class LessonConsoleTest {
    private final List<String> told = new ArrayList<>();
    private String action = "";

    private final LessonConsole.Troubles troubles = new LessonConsole.Troubles() {
        @Override
        public void refused(String refused, String why) {
            told.add(refused + ": " + why);
        }

        @Override
        public void ended(String program, int status, boolean isFault) {
            told.add(String.format(Locale.ROOT, "%s ended %d %b", program, status, isFault));
        }

        @Override
        public void idle(String seconds) {
            told.add("idle " + seconds);
        }
    };

    /** The console of a program that ends at once. */
    private LessonConsole console(String javaOption) throws Exception {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        Process process = new ProcessBuilder(java, javaOption)
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
        LessonRun run = new LessonRun(LessonLibrary.ofSuite().lesson("twelve-keys"), 1, new LessonFigures());
        return new LessonConsole("phone", process, new LessonEvents(run)) {
            @Override
            String action() {
                return action;
            }

            @Override
            Troubles troubles() {
                return troubles;
            }

            @Override
            void atPort(int port) {
                told.add("at " + port);
            }
        };
    }

    @Test
    void aProgramThatEndsAtItsStartIsAFault() throws Exception {
        console("-version").ended();
        console("--no-such-option").ended();
        assertEquals(List.of("phone ended 0 true", "phone ended 1 true"), told);
    }

    @Test
    void aProgramThatIsClosedIsNone() throws Exception {
        LessonConsole console = console("-version");
        console.event(Event.of("ready").with("at", "4711,4712"));
        console.ended();
        assertEquals(List.of("at 4711", "phone ended 0 false"), told);
    }

    @Test
    void theRefusalOfAnActionIsReported() throws Exception {
        LessonConsole console = console("-version");
        console.event(Event.of("error").with("text", "typed on the console"));
        action = "play";
        console.event(Event.of("error").with("text", "there is no call"));
        assertEquals(List.of("play: there is no call"), told);
    }

    @Test
    void aRobotThatHangsUpForWantOfKeysIsReported() throws Exception {
        console("-version").event(Event.of("call-idle").with("robot", "robot").with("seconds", 60));
        assertEquals(List.of("idle 60"), told);
    }
}
