package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tones drive the robot through every codec, whatever each end has chosen for itself. */
class SpeechCodecTest {
    private static final String KEYS = "**#**20#*#90**";

    @ParameterizedTest
    @CsvSource({"gsm,gsm", "gsm,alaw", "alaw,gsm", "alaw,alaw"})
    void keysAndReplyTonesArriveExactly(String ofPhone, String ofRobot) throws Exception {
        try (Scenario scenario = new Scenario("phone speaks " + ofPhone + ", robot " + ofRobot)) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--speed", "10", "--codec", ofRobot);
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--codec", ofPhone);
            scenario.call(phone);
            phone.say("press " + KEYS);
            for (char key : KEYS.toCharArray()) {
                assertEquals(String.valueOf(key), robot.expectNext("keys").field("keys"), "of " + KEYS + " in order");
            }
            robot.expectNext("outcome", "tone", "3");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "3");
            phone.say("hangup");
            robot.expect("released", "cause", "16");
        }
    }

    @Test
    void bothWordsStandInTheHelp() throws Exception {
        for (String program : new String[] {"simgsm-phone", "simrobot"}) {
            FinishedProgram help = FinishedProgram.run(program, "--help");
            assertEquals(true, help.output().contains("--codec alaw|gsm"), help.output());
            FinishedProgram refused = FinishedProgram.run(program, "--codec=amr");
            assertEquals(2, refused.status());
        }
    }
}
