package simrobot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RecordingsTest {
    @Test
    void aRobotAloneIsRecordedInTheFileThatWasNamed() {
        assertEquals(Path.of("a", "calls.wav"), Recordings.pathOf(Path.of("a", "calls.wav"), "robot", 1));
    }

    @ParameterizedTest
    @CsvSource({
        "calls.wav, calls-anna.wav",
        "day/calls.wav, day/calls-anna.wav",
        "calls, calls-anna",
        "a.b/calls, a.b/calls-anna",
        ".wav, .wav-anna"
    })
    void ofSeveralRobotsEachHasItsNameBeforeTheEnding(String file, String expected) {
        assertEquals(Path.of(expected), Recordings.pathOf(Path.of(file), "anna", 2));
    }
}
