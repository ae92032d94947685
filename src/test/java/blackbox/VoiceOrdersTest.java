package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** A caller with enrolled words orders by voice; the caller's voice is that of the prompts. */
class VoiceOrdersTest {
    /** The phone knows the prompts half a second after its first call began. */
    private static void askForStatus(RunningProgram phone) {
        phone.say("press ** #*0 **");
        phone.expect("words");
    }

    @Test
    void aSpokenOrderIsReadBackAndExecutedAfterYesAndTheNextKeysStillWork() throws IOException, InterruptedException {
        try (Scenario scenario = new Scenario("an order by voice")) {
            Path data = scenario.folder().resolve("robot-data");
            SpokenWords.enrol(data, scenario.folder());
            scenario.center();
            RunningProgram robot = scenario.robot("demo.map", "--voice", "--data", data.toString());
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            askForStatus(phone);
            phone.say("press *#");
            robot.expect("said", "text", "Say forward turn stop or status");
            phone.expect("words", "text", "Say forward turn stop or status");
            phone.say("play " + SpokenWords.file(scenario.folder(), "forward", "two", "zero"));
            for (String word : List.of("forward", "two", "zero")) {
                assertEquals(word, robot.expect("heard", "verdict", "sure").field("word"));
            }
            assertEquals("Forward two zero say yes", robot.expect("said").field("text"));
            phone.expect("words", "text", "Forward two zero say yes");
            phone.say("play " + scenario.folder().resolve("yes.wav"));
            assertEquals("yes", robot.expect("heard").field("word"));
            assertEquals(
                    "**#**20**", robot.expect("order", "verdict", "accepted").field("text"));
            phone.expect("tone", "key", "3");
            phone.say("press ** #*0 **");
            phone.expect("tone", "key", "3");
        }
    }

    @Test
    void aNewCallerEnrolsAndTheVoiceIsKeptByNumber() throws IOException {
        try (Scenario scenario = new Scenario("an enrolment")) {
            Path data = scenario.folder().resolve("robot-data");
            scenario.center();
            RunningProgram robot = scenario.robot("demo.map", "--voice", "--data", data.toString());
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            askForStatus(phone);
            phone.say("press *#");
            robot.expect("said");
            String asked = robot.expect("said").field("text");
            // on a busy machine a word may be lost, and is asked again
            while (asked.equals("Say forward")) {
                phone.expect("words", "text", asked);
                phone.say("play " + SpokenWords.file(scenario.folder(), "forward"));
                phone.expect("played");
                asked = robot.expect("said").field("text");
            }
            assertEquals("Say turn", asked);
            Path kept = data.resolve("voices").resolve(Scenario.PHONE);
            assertTrue(Files.exists(kept.resolve("forward.2.word")), kept.toString());
        }
    }
}
