package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** {@code --at-audio}: the dialogue of Asterisk's chan_dongle, and the sound of calls on the second port. */
class SoundOfCallsTest {
    private static final String OPERATOR = "5550103";

    @Test
    void aRobotIsCalledAndCommandedThroughAPhoneAsThroughADongle() throws Exception {
        try (Scenario scenario = new Scenario("chan_dongle on a phone")) {
            scenario.center();
            RunningProgram robot = scenario.robot("empty.map", "--speed", "20");
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--at", "0", "--at-audio", "0");
            try (DongleClient dongle = new DongleClient(phone)) {
                dongle.initialise();
                scenario.tell("an outgoing call with keys as sound");
                assertTrue(dongle.call(Scenario.ROBOT) >= 2);
                dongle.code("\\^ORIG:1,0");
                dongle.code("\\^CONF:1");
                dongle.code("\\^CONN:1,0");
                robot.expect("tone", "key", "1");
                dongle.press("** #**20 **");
                robot.expect("order", "text", "**#**20**", "verdict", "accepted");
                robot.expect("tone", "key", "3");
                scenario.tell("keys by command");
                for (char key : "**#*0**".toCharArray()) {
                    dongle.ok("AT^DTMF=1," + key);
                }
                robot.expect("order", "text", "**#*0**");
                robot.expect("tone", "key", "3");
                dongle.ok("AT+CHUP");
                dongle.code("\\^CEND:1,\\d+,67,16");
                robot.expect("released", "cause", "16");
                assertTrue(dongle.keysHeard().startsWith("163"), dongle.keysHeard());
                assertTrue(dongle.framesRead() > 100, "frames: " + dongle.framesRead());
            }
        }
    }

    @Test
    void aCallToTheDongleIsAnsweredWithSoundAndMessagesGoBothWays() throws Exception {
        try (Scenario scenario = new Scenario("chan_dongle is called")) {
            scenario.center();
            RunningProgram phone = scenario.phone(Scenario.PHONE, "--at", "0", "--at-audio", "0");
            RunningProgram far = scenario.phone(OPERATOR);
            try (DongleClient dongle = new DongleClient(phone)) {
                dongle.initialise();
                far.say("dial " + Scenario.PHONE).expect("alerting");
                dongle.answer(OPERATOR);
                far.expect("connected");
                dongle.press("5#");
                far.expect("tone", "key", "5");
                far.expect("tone", "key", "#");
                far.say("press 147").expect("sent", "keys", "147");
                far.say("hangup").expect("released");
                dongle.code("\\^CEND:1,\\d+,67,16");
                assertEquals("147", dongle.keysHeard());
                scenario.tell("a message to the dongle, and one from it");
                far.say("sms " + Scenario.PHONE + " Hello");
                assertTrue(dongle.readMessage().contains("C8329BFD06"));
                dongle.submit("0001000781" + "550501F3" + "000005C8329BFD06");
                far.expect("sms", "from", Scenario.PHONE, "text", "Hello");
            }
        }
    }

    /** The phone's ports serve as the two lines of a real modem. */
    @Test
    void aRobotHearsTheKeysInTheSoundOfItsModem() throws Exception {
        try (Scenario scenario = new Scenario("a real modem's sound")) {
            scenario.center();
            RunningProgram modem = scenario.phone(Scenario.ROBOT, "--at", "0", "--at-audio", "0");
            Path recording = scenario.folder().resolve("calls.wav");
            RunningProgram robot = scenario.start(
                    "robot",
                    "simrobot",
                    "--headless",
                    "--no-sound",
                    "--speed=20",
                    "--world=" + Scenario.world("empty.map"),
                    "--modem=127.0.0.1:" + modem.said("ready").field("at"),
                    "--modem-audio=127.0.0.1:" + modem.said("ready").field("at-audio"),
                    "--record-audio=" + recording);
            robot.expect("registered", "number", Scenario.ROBOT);
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            scenario.call(phone);
            robot.expect("call", "from", Scenario.PHONE);
            phone.say("press ** #**20 **");
            phone.expectNext("tone", "key", "6");
            phone.expectNext("tone", "key", "3");
            robot.expect("outcome", "tone", "3");
            phone.say("press ** #**0 **");
            phone.expectNext("tone", "key", "7");
            phone.say("hangup").expect("released", "cause", "16");
            robot.expect("released", "cause", "16");
            assertEquals(0, robot.quit());
            assertEquals("163", RecordingTest.decoded(recording, 0).substring(0, 3));
            String heard = RecordingTest.decoded(recording, 1);
            assertTrue(heard.startsWith("**#**20****#**0"), heard);
        }
    }
}
