package simrobot.app;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import simgsm.words.FrontEnd;
import simgsm.words.SpeechFrame;
import simgsm.words.SpokenWord;

class CallerVoicesTest {
    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aCallersVoiceIsReadableByTheOwnerOnly(@TempDir Path data) throws Exception {
        List<SpeechFrame> frames = new ArrayList<>();
        new FrontEnd(frames::add).accept(new short[4_000]);
        CallerVoices voices = new CallerVoices(data.resolve("voices"));
        voices.add("5550100", "stop", 1, SpokenWord.of(frames));
        Path folder = data.resolve("voices/5550100");
        assertEquals("rwx------", PosixFilePermissions.toString(Files.getPosixFilePermissions(folder)));
        assertEquals(1, voices.read("5550100").words().size());
    }
}
