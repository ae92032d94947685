package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import javax.sound.sampled.AudioFileFormat;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** What is heard: the programs play to a sound device that writes all it gets into a file. Skipped where there is no ALSA. */
@Isolated("speech in real time, recorded by a device")
class SoundTest {
    private static final Path ALSA = Path.of("/usr/share/alsa/alsa.conf");

    @TempDir
    Path folder;

    /** An environment whose sound device is a file. */
    private Map<String, String> deviceInto(Path file) throws Exception {
        assumeTrue(Files.exists(ALSA), "no ALSA here");
        Path settings = folder.resolve(file.getFileName() + ".conf");
        Files.writeString(
                settings,
                "<" + ALSA + ">\n" + "pcm.!default { type file; slave.pcm null; format raw; file \"" + file + "\" }\n");
        return Map.of("ALSA_CONFIG_PATH", settings.toString());
    }

    private String decoded(Path raw) throws Exception {
        assumeTrue(Files.exists(raw), "Java finds no sound device here");
        byte[] octets = Files.readAllBytes(raw);
        Path wav = folder.resolve(raw.getFileName() + ".wav");
        AudioFormat format = new AudioFormat(8000, 16, 1, true, false);
        AudioSystem.write(
                new AudioInputStream(new ByteArrayInputStream(octets), format, octets.length / 2),
                AudioFileFormat.Type.WAVE,
                wav.toFile());
        FinishedProgram decoder = FinishedProgram.run("simgsm-modem", "decode", wav.toString());
        assertEquals(0, decoder.status(), decoder.error());
        return decoder.output().split("\t")[1];
    }

    @Test
    void phoneAndRobotLetKeysAndRepliesBeHeard() throws Exception {
        Path atPhone = folder.resolve("phone.raw");
        Path atRobot = folder.resolve("robot.raw");
        try (Scenario scenario = new Scenario("both ends have a sound device")) {
            scenario.center();
            RunningProgram robot = scenario.start(
                    "robot",
                    deviceInto(atRobot),
                    "simrobot",
                    "--headless",
                    "--center=" + scenario.centerAddress(),
                    "--world=" + Scenario.world("empty.map"),
                    "--speed=10");
            robot.expect("registered");
            RunningProgram phone = scenario.start(
                    "phone",
                    deviceInto(atPhone),
                    "simgsm-phone",
                    "--headless",
                    "--dtmf=signalled",
                    "--center=" + scenario.centerAddress());
            phone.expect("registered");
            scenario.call(phone);
            robot.expect("tone", "key", "1");
            phone.say("press 5**#**20**");
            robot.expect("tone", "key", "3");
            phone.expect("tone", "key", "3");
            scenario.tell("another key, so that the reply has been heard to its end before the call is over");
            phone.say("press 0");
            robot.expect("keys", "keys", "0");
            phone.expect("sent", "keys", "0");
            phone.say("hangup");
            robot.expect("released");
            assertEquals(0, phone.quit());
            assertEquals(0, robot.quit());
            assertFalse(phone.log().contains("ALSA"), phone.log());
        }
        // A device takes a moment to open, so the first tone may have passed before; and tone 6 sets in while the last
        // key still sounds, so in one room those two are heard as a mixture.
        assertTrue(decoded(atPhone).matches(".*5\\*\\*#\\*\\*20\\*.*3.*"), decoded(atPhone));
        assertTrue(decoded(atRobot).matches(".*5\\*\\*#\\*\\*20\\*.*3.*"), decoded(atRobot));
    }

    @Test
    void withNoSoundTheDeviceIsLeftAlone() throws Exception {
        Path file = folder.resolve("silent.raw");
        try (Scenario scenario = new Scenario("--no-sound")) {
            scenario.center();
            RunningProgram one = scenario.phone("5550102");
            RunningProgram phone = scenario.start(
                    "phone",
                    deviceInto(file),
                    "simgsm-phone",
                    "--headless",
                    "--no-sound",
                    "--center=" + scenario.centerAddress());
            phone.expect("registered");
            phone.say("dial 5550102");
            one.expect("ringing");
            one.say("answer");
            phone.expect("connected");
            phone.say("press 12");
            one.expect("tone", "key", "2");
            phone.quit();
        }
        assertTrue(Files.notExists(file));
    }
}
