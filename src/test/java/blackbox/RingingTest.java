package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

/** M2 rings before it answers: for how long, and what can happen meanwhile. */
class RingingTest {
    private VirtualPhone calling(VirtualSuite suite) {
        VirtualPhone phone = suite.phone(VirtualSuite.PHONE);
        phone.dial(VirtualSuite.ROBOT);
        return phone;
    }

    private List<String> callLines(VirtualSuite suite) {
        return suite.robotLines.stream()
                .filter(line -> line.matches("(ringing|call|released) .*"))
                .toList();
    }

    @Test
    void theRobotRingsForAnswerAfterAndThenTakesTheCall() {
        VirtualSuite suite = new VirtualSuite(1500);
        VirtualPhone phone = calling(suite);
        suite.seconds(1.4);
        assertEquals(List.of("ringing robot=robot from=5550100"), callLines(suite));
        assertEquals("", phone.tones());
        suite.seconds(0.6);
        assertEquals(List.of("ringing robot=robot from=5550100", "call robot=robot from=5550100"), callLines(suite));
        assertEquals("1", phone.tones());
    }

    @Test
    void aHangUpWhileItRingsIsReleasedWithoutACall() {
        VirtualSuite suite = new VirtualSuite(1500);
        VirtualPhone phone = calling(suite);
        suite.seconds(1);
        phone.hangUp();
        suite.seconds(3);
        assertEquals(List.of("ringing robot=robot from=5550100", "released robot=robot cause=16"), callLines(suite));
    }

    @Test
    void aSecondCallerHearsBusyWhileItRings() {
        VirtualSuite suite = new VirtualSuite(1500);
        calling(suite);
        suite.seconds(1);
        VirtualPhone second = suite.phone("5550101");
        second.dial(VirtualSuite.ROBOT);
        suite.seconds(0.3);
        assertEquals(List.of(17), second.releaseCauses);
    }

    @Test
    void whetherTheRobotIsOnCountsWhenTheCallIsAnswered() {
        VirtualSuite suite = new VirtualSuite(1500);
        VirtualPhone phone = calling(suite);
        suite.seconds(1);
        suite.robot.setPower(false);
        suite.seconds(2);
        assertEquals("2", phone.tones());
        assertEquals(List.of(16), phone.releaseCauses);
    }

    @Test
    void aMessageOrderUnderWayGoesOnWhenACallerGivesUpRinging() {
        VirtualSuite suite = new VirtualSuite(1500);
        VirtualPhone phone = suite.phone(VirtualSuite.PHONE);
        phone.message(VirtualSuite.ROBOT, "** #**100 **");
        suite.seconds(1);
        phone.dial(VirtualSuite.ROBOT);
        suite.seconds(1);
        phone.hangUp();
        suite.seconds(10);
        assertEquals(1, suite.robot.xMeters(), 0.001);
    }

    @Test
    void theProgramRingsOneAndAHalfSecondsByDefault() throws Exception {
        try (Scenario scenario = new Scenario("ringing")) {
            scenario.center();
            RunningProgram robot = scenario.start(
                    "robot",
                    "simrobot",
                    "--headless",
                    "--no-sound",
                    "--center",
                    scenario.centerAddress(),
                    "--world",
                    Scenario.world("empty.map").toString());
            robot.expect("registered");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            phone.say("dial " + Scenario.ROBOT);
            phone.expectBefore(Set.of("connected"), "alerting");
            robot.expect("ringing", "from", Scenario.PHONE);
            scenario.tell("the caller gives up while it rings");
            phone.say("hangup").expect("released", "cause", "16");
            robot.expectBefore(Set.of("call"), "released", "cause", "16");
            scenario.tell("and waits the next time");
            scenario.call(phone);
            robot.expectBefore(Set.of("call"), "ringing");
            robot.expectBefore(Set.of("tone"), "call", "from", Scenario.PHONE);
        }
    }

    @Test
    void aTimeThatIsNoneIsAUsageError() throws Exception {
        for (String time : List.of("-1", "120001", "soon")) {
            FinishedProgram refused = FinishedProgram.run("simrobot", "--headless", "--answer-after=" + time);
            assertEquals(2, refused.status());
            assertTrue(refused.error().contains("--answer-after"), refused.error());
        }
    }
}
