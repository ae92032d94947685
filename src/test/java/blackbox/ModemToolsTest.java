package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import javax.sound.sampled.AudioFileFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code simgsm-modem.jar}: tones into files and back. */
class ModemToolsTest {
    @TempDir
    private Path folder;

    private Path tones(String keys) throws Exception {
        Path file = folder.resolve("tones.wav");
        FinishedProgram made = FinishedProgram.run("simgsm-modem", "tones", keys, file.toString());
        assertEquals(0, made.status(), made.error());
        return file;
    }

    @Test
    void whatToneWroteDecodeReadsWithTheTimeOfEveryDecision() throws Exception {
        Path file = tones("** #**20 **ABCD1346789");
        FinishedProgram decoded = FinishedProgram.run("simgsm-modem", "decode", file.toString());
        assertEquals(0, decoded.status(), decoded.error());
        String[] columns = decoded.output().stripTrailing().split("\t");
        assertEquals(file.toString(), columns[0]);
        assertEquals("**#**20**ABCD1346789", columns[1]);
        String[] times = columns[2].split(",");
        assertEquals(columns[1].length(), times.length);
        for (int i = 0; i < times.length; i++) {
            double afterStart = Double.parseDouble(times[i]) - 200.0 * i;
            assertTrue(afterStart >= 20 && afterStart <= 60, "digit " + i + " decided after " + afterStart + " ms");
        }
    }

    @Test
    void noiseTwentyDecibelsBelowTheTonesIsHarmlessAndTwentyAboveThemHidesThem() throws Exception {
        assertEquals("159", decodedWithNoise("20"));
        assertEquals("", decodedWithNoise("-20"));
    }

    private String decodedWithNoise(String decibels) throws Exception {
        String file = folder.resolve("noisy.wav").toString();
        FinishedProgram made =
                FinishedProgram.run("simgsm-modem", "tones", "159", file, "--noise", decibels, "--seed", "3");
        assertEquals(0, made.status(), made.error());
        return FinishedProgram.run("simgsm-modem", "decode", file).output().split("\t", -1)[1];
    }

    @Test
    void theFileIsEightKilohertzSixteenBitMono() throws Exception {
        try (AudioInputStream audio =
                AudioSystem.getAudioInputStream(tones("12").toFile())) {
            assertEquals(8000, audio.getFormat().getSampleRate());
            assertEquals(16, audio.getFormat().getSampleSizeInBits());
            assertEquals(1, audio.getFormat().getChannels());
            assertTrue(audio.getFrameLength() >= 2 * 1600 - 800, "frames: " + audio.getFrameLength());
        }
    }

    @Test
    void silenceHasNoDigitsAndAFileThatIsNoAudioIsSaidAtTheEnd() throws Exception {
        Path text = Files.writeString(folder.resolve("text.wav"), "no audio");
        Path silence = folder.resolve("silence.wav");
        try (AudioInputStream nothing = new AudioInputStream(
                new java.io.ByteArrayInputStream(new byte[16000]),
                new javax.sound.sampled.AudioFormat(8000, 16, 1, true, false),
                8000)) {
            AudioSystem.write(nothing, AudioFileFormat.Type.WAVE, silence.toFile());
        }
        FinishedProgram decoded = FinishedProgram.run("simgsm-modem", "decode", text.toString(), silence.toString());
        assertEquals(1, decoded.status());
        assertEquals(text + "\t\t\n" + silence + "\t\t\n", decoded.output());
        assertTrue(decoded.error().contains("text.wav"), decoded.error());
    }

    @Test
    void keysThatDoNotExistAreRefused() throws Exception {
        FinishedProgram refused = FinishedProgram.run(
                "simgsm-modem", "tones", "12x", folder.resolve("x.wav").toString());
        assertEquals(2, refused.status());
        assertTrue(refused.error().contains("x"), refused.error());
    }
}
