package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Set;
import org.junit.jupiter.api.Test;

/** With {@code --call-waiting on} a second caller waits where he would else hear that the number is busy. */
class CallWaitingTest {
    private static final String SECOND = "5550101";
    private static final String THIRD = "5550102";

    @Test
    void theSecondCallRingsWhenTheFirstHasEndedUnlessItGivesUpAndARobotStaysBusy() throws Exception {
        try (Scenario scenario = new Scenario("a call that waits")) {
            RunningProgram center = scenario.center("--call-waiting", "on");
            RunningProgram phone = scenario.phone(Scenario.PHONE);
            RunningProgram second = scenario.phone(SECOND);
            RunningProgram third = scenario.phone(THIRD);
            phone.say("dial " + SECOND);
            second.expect("ringing", "from", Scenario.PHONE);
            second.say("answer");
            phone.expect("connected");
            second.expect("connected");

            scenario.tell("a caller who waits gives up");
            third.say("dial " + SECOND);
            second.expect("waiting", "from", THIRD);
            third.expectBefore(Set.of("released"), "alerting");
            third.say("hangup");
            second.expectBefore(Set.of("released"), "waiting-over");
            third.expect("released");

            scenario.tell("the next one waits; the first call ends, the second rings");
            third.say("dial " + SECOND);
            second.expect("waiting", "from", THIRD);
            third.expectBefore(Set.of("released"), "alerting");
            center.expect("call", "from", THIRD, "state", "alerting");
            second.say("hangup");
            phone.expect("released", "cause", "16");
            second.expect("ringing", "from", THIRD);
            second.say("answer");
            third.expectBefore(Set.of("released"), "connected");
            third.say("hangup");
            second.expect("released", "cause", "16");

            scenario.tell("a robot stays busy");
            RunningProgram robot = scenario.robot("empty.map");
            scenario.call(phone);
            second.say("dial " + Scenario.ROBOT);
            second.expect("released", "cause", "17");
            phone.say("hangup");
            robot.expect("released", "cause", "16");
            for (RunningProgram each : new RunningProgram[] {robot, phone, second, third, center}) {
                assertEquals(0, each.quit());
            }
        }
    }
}
