package simrobot.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simgsm.speech.CallAudioListener;

class CallRecordingsTest {
    @TempDir
    Path folder;

    @Test
    void aSingleRobotIsRecordedInTheNamedFileAndLaterRobotsBesideIt() throws Exception {
        CallRecordings recordings = new CallRecordings(Optional.of(folder.resolve("calls.wav")), true);
        recordings.of("robot").close();
        recordings.of("anna").close();
        assertTrue(Files.exists(folder.resolve("calls.wav")));
        assertTrue(Files.exists(folder.resolve("calls-anna.wav")));
    }

    @Test
    void withoutAFileNothingIsRecorded() throws Exception {
        assertSame(CallAudioListener.NONE, new CallRecordings(Optional.empty(), true).of("robot"));
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
        assertEquals(Path.of(expected), CallRecordings.pathOf(Path.of(file), "anna"));
    }
}
