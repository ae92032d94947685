package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.sound.sampled.AudioFileFormat;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** Recorded calls hold every key of both sides, as our own decoder hears them. */
@Isolated("speech in real time, recorded at both ends")
class RecordingTest {
    private static final int LEFT = 0;
    private static final int RIGHT = 1;

    /** The keys in one of the channels; both together overlap, since a caller keys while a reply still sounds. */
    static String decoded(Path file, int channel) throws Exception {
        Path mono = file.resolveSibling(file.getFileName() + "-" + channel + ".wav");
        try (AudioInputStream stream = AudioSystem.getAudioInputStream(file.toFile())) {
            assertEquals(2, stream.getFormat().getChannels());
            assertEquals(8000, stream.getFormat().getSampleRate());
            byte[] both = stream.readAllBytes();
            byte[] one = new byte[both.length / 2];
            for (int i = 0; i < one.length; i++) {
                one[i] = both[i / 2 * 4 + 2 * channel + i % 2];
            }
            AudioFormat format = new AudioFormat(8000, 16, 1, true, false);
            AudioSystem.write(
                    new AudioInputStream(new ByteArrayInputStream(one), format, one.length / 2),
                    AudioFileFormat.Type.WAVE,
                    mono.toFile());
        }
        FinishedProgram decoder = FinishedProgram.run("simgsm-modem", "decode", mono.toString());
        assertEquals(0, decoder.status(), decoder.error());
        return decoder.output().split("\t")[1];
    }

    @Test
    void phoneAndRobotRecordKeysAndReplies(@TempDir Path folder) throws Exception {
        Path ofPhone = folder.resolve("phone.wav");
        Path ofRobot = folder.resolve("robot.wav");
        try (Scenario scenario = new Scenario("two calls are recorded at both ends")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--speed", "10", "--record-audio", ofRobot.toString());
            RunningProgram phone =
                    scenario.phone(Scenario.PHONE, "--codec", "gsm", "--record-audio", ofPhone.toString());
            for (String order : new String[] {"**#**20**", "**#*#45**"}) {
                scenario.call(phone);
                phone.say("press " + order);
                phone.expect("tone", "key", "3");
                robot.expect("tone", "key", "3");
                phone.say("hangup");
                robot.expect("released");
            }
            assertEquals(0, phone.quit());
            assertEquals(0, robot.quit());
        }
        assertEquals("**#**20****#*#45**", decoded(ofPhone, LEFT));
        assertEquals("163163", decoded(ofPhone, RIGHT));
        assertEquals("163163", decoded(ofRobot, LEFT));
        assertEquals("**#**20****#*#45**", decoded(ofRobot, RIGHT));
    }

    @Test
    void aKilledPhoneLeavesAFileThatCanBeRead(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("killed.wav");
        try (Scenario scenario = new Scenario("killed while recording")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map");
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--record-audio=" + file);
            scenario.call(phone);
            phone.say("press 5550199 0");
            robot.expect("keys", "keys", "0");
            robot.expect("keys", "keys", "0");
            phone.kill();
            assertTrue(decoded(file, LEFT).startsWith("555019"), decoded(file, LEFT));
            assertTrue(decoded(file, RIGHT).startsWith("1"), decoded(file, RIGHT));
        }
    }

    @Test
    void severalRobotsHaveAFileEach(@TempDir Path folder) throws Exception {
        try (Scenario scenario = new Scenario("two robots, one of them called")) {
            scenario.center();
            RunningProgram robots = scenario.robot(
                    "empty.map",
                    "--robot=anna=5550200",
                    "--robot=bert=5550201",
                    "--record-audio",
                    folder.resolve("calls.wav").toString());
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            phone.say("dial 5550201");
            phone.expect("tone", "key", "1");
            phone.say("press 99");
            phone.expect("sent");
            phone.say("hangup");
            robots.expect("released", "robot", "bert");
            robots.quit();
            assertEquals("", decoded(folder.resolve("calls-anna.wav"), RIGHT));
            assertEquals("99", decoded(folder.resolve("calls-bert.wav"), RIGHT));
        }
    }

    @Test
    void aFileThatCannotBeWrittenIsAnInputOutputError(@TempDir Path folder) throws Exception {
        Path nowhere = folder.resolve("nowhere").resolve("a.wav");
        for (String program : new String[] {"simgsm-phone", "simrobot"}) {
            FinishedProgram refused =
                    FinishedProgram.run(program, "--headless", "--no-sound", "--record-audio", nowhere.toString());
            assertEquals(74, refused.status(), refused.error());
            assertTrue(refused.error().contains("a.wav"), refused.error());
            assertEquals("", refused.output());
            assertTrue(Files.notExists(nowhere));
        }
    }
}
