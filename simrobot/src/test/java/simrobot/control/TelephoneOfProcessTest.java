package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.BehaviourAnswer;
import simrobot.behaviour.BehaviourRequest;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;
import simrobot.process.BehaviourKind;
import simrobot.process.Decision;
import vericommand.RobotStatus;

/** What a process hears of the call and sends by the telephone: process 3 of a robot without a modem. */
class TelephoneOfProcessTest {
    private static final String CALLER = "5550100";

    private final ControlBench bench = new ControlBench();
    private final List<String> heard = new ArrayList<>();
    private final Behaviour joystick = senses -> {
        heard.add(senses.key() + senses.call().pressed());
        return senses.key() == '2' ? new Steering(0.3, 0) : Steering.STOP;
    };

    private void offer(Behaviour behaviour) {
        bench.simulation.behaviours().put(new BehaviourKind("Mine", around -> senses -> {
            BehaviourAnswer answer = BehaviourAnswer.of(behaviour, senses);
            return new Decision.Go(answer.steering(), answer.asked());
        }));
    }

    private void call(Behaviour behaviour) {
        offer(behaviour);
        bench.control.callBegan(1, CALLER);
        tap("**#*3**");
        bench.seconds(0.2);
        heard.clear();
    }

    private void tap(String keys) {
        for (char key : keys.toCharArray()) {
            bench.press(String.valueOf(key));
            bench.control.keyEnded();
        }
    }

    @Test
    void aHeldKeyDrivesUntilItIsReleased() {
        call(joystick);
        bench.press("2");
        bench.seconds(1);
        double held = bench.robot.xMeters();
        assertTrue(held > 0.1, "drove " + held);
        assertEquals("22", heard.get(0));
        assertEquals("2", heard.get(1));
        bench.control.keyEnded();
        bench.seconds(2);
        assertEquals(" ", heard.get(heard.size() - 1));
        assertEquals(0, bench.robot.speedMetersPerSecond());
        assertEquals(RobotStatus.MOVING, bench.robot.status());
    }

    @Test
    void aKeyTappedBetweenTwoDecisionsIsHeardOnce() {
        call(joystick);
        tap("58");
        bench.seconds(0.3);
        assertEquals(List.of("858", " ", " "), heard);
    }

    @Test
    void keysOfTheProcessAreNoStrayOrder() {
        call(joystick);
        tap("2#46*8");
        bench.control.speech(80_000);
        assertEquals(List.of(), bench.lines("outcome robot=robot tone=7"));
    }

    @Test
    void twoStarsEndTheProcessAndTheirOrderIsDoneOnceTheRobotStands() {
        call(joystick);
        bench.press("2");
        bench.seconds(1);
        bench.control.keyEnded();
        bench.lines("");
        tap("**");
        assertEquals(BehaviourKind.NONE, bench.robot.autonomy().kind());
        tap("#*#90**");
        bench.seconds(6);
        assertEquals(
                List.of("order robot=robot text=**#*#90** verdict=accepted", "modem: tone 6", "modem: tone 3"),
                bench.lines("order", "modem: tone"));
        assertEquals(270, bench.robot.pose().headingDegrees(), 1e-6);
    }

    @Test
    void aProcessThatReadsNoKeysLeavesThemToOrders() {
        call(senses -> new Steering(0.1, 0));
        tap("**");
        assertEquals("Mine", bench.robot.autonomy().kind().text());
        tap("###**");
        bench.seconds(2);
        assertEquals(BehaviourKind.NONE, bench.robot.autonomy().kind());
    }

    @Test
    void keysOfACallThatDidNotStartItDoNotReachAProcess() {
        offer(joystick);
        bench.control.message(CALLER, "**#*3**");
        bench.control.callBegan(1, "5550101");
        tap("2");
        bench.seconds(0.5);
        assertTrue(heard.stream().allMatch(" "::equals), heard.toString());
        assertEquals("Mine", bench.robot.autonomy().kind().text());
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void theCallerIsWhoStartedIt(boolean bySms) {
        List<String> callers = new ArrayList<>();
        Behaviour asks = senses -> {
            callers.add(senses.caller());
            return Steering.STOP;
        };
        if (bySms) {
            offer(asks);
            bench.control.callBegan(1, "5550101");
            bench.control.callEnded(16);
            bench.control.message(CALLER, "**#*3**");
        } else {
            call(asks);
        }
        bench.seconds(0.3);
        assertEquals(CALLER, callers.get(callers.size() - 1));
    }

    /** A process that asks for the same in each decision. */
    private static final class Repeats implements Behaviour {
        private final String text;

        Repeats(String text) {
            this.text = text;
        }

        @Override
        public Steering decide(Senses senses) {
            sms(senses.caller(), text);
            play("59");
            return Steering.STOP;
        }
    }

    @Test
    void oneSmsIn10SecondsLeavesAndTheLimitIsToldOnce() {
        call(new Repeats("Obstacle: ñ €"));
        bench.seconds(9);
        assertEquals(
                List.of(
                        "reply robot=robot to=5550100 text=\"Obstacle: ñ €\"",
                        "printed robot=robot name=Mine text=\"error: sms to 5550100 is not sent, expected at most one in 10 s\""),
                bench.lines("reply", "printed"));
        bench.seconds(2);
        assertEquals(1, bench.lines("reply").size());
    }

    @Test
    void tonesArePlayedOneAfterAnotherAndDroppedWhileTheySound() {
        call(new Repeats("."));
        bench.lines("");
        bench.seconds(1);
        assertEquals(
                List.of("modem: tone 5", "modem: tone 9", "modem: tone 5", "modem: tone 9"),
                bench.lines("modem: tone"));
    }

    @Test
    void anSmsToNoNumberNamesWhatWasExpected() {
        offer(new Repeats("text"));
        IllegalArgumentException refused = assertThrows(IllegalArgumentException.class, () -> {
            bench.robot.autonomy().begin(bench.simulation.behaviours().of("Mine"));
            bench.seconds(1);
        });
        assertEquals("sms to \"\", expected a number of 1 to 15 digits", refused.getMessage());
    }

    @Test
    void ofManyLinesThatItPrintsTheFirstOfEachSecondAreTold() {
        offer(senses -> {
            BehaviourAnswer.ask(new BehaviourRequest.Printed("x".repeat(300) + "\n" + "y\n".repeat(59)));
            return Steering.STOP;
        });
        bench.robot.autonomy().begin(bench.simulation.behaviours().of("Mine"));
        bench.seconds(2.2);
        List<String> printed = bench.lines("printed");
        assertEquals("printed robot=robot name=Mine text=" + "x".repeat(200), printed.get(0));
        String more = printed.stream()
                .filter(line -> line.contains("more lines"))
                .findFirst()
                .orElseThrow();
        assertEquals(100, printed.indexOf(more), more);
    }
}
