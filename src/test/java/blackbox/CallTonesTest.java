package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Set;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A centre that lets callers hear its own tones: they are heard and recorded, are no keys, and delay no call. */
class CallTonesTest {
    @Test
    void aNetworksToneIsHeardAndEndsWhenTheCallerDialsAgain(@TempDir Path folder) throws Exception {
        Path recorded = folder.resolve("phone.wav");
        try (Scenario scenario = new Scenario("the network plays its own tones")) {
            scenario.center("--tones", "us");
            RunningProgram robot = scenario.robot("empty.map", "--speed", "10");
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--record-audio", recorded.toString());

            scenario.tell("an unassigned number");
            phone.say("dial 5550999");
            phone.expectBefore(Set.of("tone", "connected"), "released", "cause", "1");
            phone.say("wait nothing 2");
            phone.expectBefore(Set.of("tone", "released"), "error");
            assertTrue(loudest(recorded) > 1000, "only " + loudest(recorded));

            scenario.tell("the next call is none the worse for it");
            phone.say("dial 5550200");
            phone.expectBefore(Set.of("tone", "released"), "connected");
            phone.expect("tone", "key", "1");
            phone.say("press **#*#45**");
            phone.expect("tone", "key", "3");

            scenario.tell("a second caller finds the robot busy");
            RunningProgram other = scenario.phone("5550101", "--tones=us");
            other.say("dial 5550200");
            other.expectBefore(Set.of("tone", "connected"), "released", "cause", "17");
            other.say("hangup");
            phone.say("hangup");
            robot.expect("released", "cause", "16");
            other.say("dial 5550200");
            other.expectBefore(Set.of("released"), "connected");
        }
    }

    @Test
    void whichTonesMustBeKnown() throws Exception {
        for (String program : new String[] {"simgsm-phone", "simgsm-center"}) {
            FinishedProgram refused = FinishedProgram.run(program, "--headless", "--tones", "uk");
            assertEquals(2, refused.status(), refused.error());
            assertTrue(refused.error().contains("--tones") && refused.error().contains("eu or us"), refused.error());
        }
    }

    /** The loudest sample of what was received. */
    private static int loudest(Path file) throws Exception {
        try (AudioInputStream stream = AudioSystem.getAudioInputStream(file.toFile())) {
            byte[] both = stream.readAllBytes();
            int most = 0;
            for (int i = 2; i + 1 < both.length; i += 4) {
                most = Math.max(most, Math.abs(both[i] & 0xff | both[i + 1] << 8));
            }
            return most;
        }
    }
}
