package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A robot with {@code --speak} says its replies; the phone reads them by ear. */
class SpokenRepliesTest {
    private static final String HEARD = "Done stopped at x zero meters y zero meters heading zero";

    @ParameterizedTest(name = "robot {0}, phone {1}, over {2}")
    @CsvSource({"alaw, alaw, ''", "gsm, alaw, ''", "alaw, gsm, village.town"})
    void theStatusIsSaidAfterItsToneAndReadByThePhoneOverEveryPath(String robotCodec, String phoneCodec, String town)
            throws IOException {
        try (Scenario scenario = new Scenario("a spoken status")) {
            scenario.center();
            if (!town.isEmpty()) {
                scenario.cells(town);
            }
            RunningProgram robot = scenario.robot("demo.map", "--speak", "--codec", robotCodec);
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--codec", phoneCodec);
            scenario.call(phone);
            phone.say("press ** #*0 **");
            phone.expect("tone", "key", "3");
            assertEquals(HEARD, robot.expect("said").field("text"));
            assertEquals(HEARD, phone.expect("words").field("text"));
        }
    }

    @Test
    void aKeyEndsTheWordsAndTheNextReplyIsSaidInSpanishWithAPersonsRecording() throws IOException {
        try (Scenario scenario = new Scenario("words that a key ends")) {
            Path own = Files.createDirectory(scenario.folder().resolve("own"));
            Files.write(own.resolve("hecho.gsm"), silence(5));
            scenario.center();
            RunningProgram robot = scenario.robot("demo.map", "--speak", "--lang", "es", "--prompts", own.toString());
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            phone.say("press ** #*0 **");
            robot.expect("said");
            phone.say("press ** 5");
            phone.expect("tone", "key", "7");
            String fault = "La orden no vale se espera almohadilla en la tecla tres";
            assertEquals(fault, robot.expect("said").field("text"));
            assertEquals(fault, phone.expect("words").field("text"));
        }
    }

    /** Frames whose pulses are nought. */
    private static byte[] silence(int frames) {
        byte[] octets = new byte[33 * frames];
        for (int i = 0; i < octets.length; i += 33) {
            octets[i] = (byte) 0xD0;
        }
        return octets;
    }

    @ParameterizedTest
    @CsvSource({
        "'--prompts .', 'expected with --speak or --voice'",
        "'--speak --prompts nowhere', 'expected a folder, found nowhere'"
    })
    void promptsWithoutAVoiceOrAFolderAreRefused(String options, String reason)
            throws IOException, InterruptedException {
        FinishedProgram robot = FinishedProgram.run("simrobot", ("--headless " + options).split(" "));
        assertEquals(
                "simrobot: --prompts: " + reason + "; see --help", robot.error().strip());
    }
}
