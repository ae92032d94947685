package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simgsm.dtmf.DtmfKey;
import vericommand.RobotStatus;

/** The whole way from sound to motion and back, without threads, sockets or a clock. */
class TelephoneSceneTest {
    private static TelephoneScene called(String... operators) {
        TelephoneScene scene = new TelephoneScene(operators);
        scene.dial();
        scene.seconds(0.5);
        return scene;
    }

    private static List<String> lines(TelephoneScene scene, String name) {
        return scene.lines.stream().filter(line -> line.startsWith(name + " ")).toList();
    }

    @Test
    void thePapersExampleThroughSound() {
        TelephoneScene scene = called();
        assertEquals("1", scene.tonesHeard.toString());
        scene.press("**#**20**");
        scene.seconds(5);
        assertEquals("163", scene.tonesHeard.toString());
        assertEquals(0.2, scene.robot.xMeters(), 1e-6);
        assertEquals(
                List.of(
                        "registered robot=robot number=5550200",
                        "ringing robot=robot from=5550100",
                        "call robot=robot from=5550100",
                        "tone robot=robot key=1"),
                scene.lines.subList(0, 4));
        assertEquals(
                List.of("tone robot=robot key=1", "tone robot=robot key=6", "tone robot=robot key=3"),
                lines(scene, "tone"));
    }

    @Test
    void fiftyOrdersOfEachKindAreExactFiftyTimes() {
        TelephoneScene scene = called();
        StringBuilder expected = new StringBuilder("1");
        for (int i = 0; i < 50; i++) {
            scene.robot.place(0, 0, 0);
            scene.press("**#**20**");
            scene.seconds(4);
            assertEquals(0.2, scene.robot.xMeters(), 0.001, "order " + i);
            scene.press("**#*#90**");
            scene.seconds(4.5);
            assertEquals(Math.toRadians(-90), scene.robot.headingRadians(), Math.toRadians(0.1), "order " + i);
            expected.append("6363");
        }
        assertEquals(expected.toString(), scene.tonesHeard.toString());
    }

    @Test
    void fromTheLastKeyToTheWheelsItIsLessThanNinetyMilliseconds() {
        for (int shiftMillis = 0; shiftMillis < 20; shiftMillis++) {
            TelephoneScene scene = called();
            long start = scene.nowNanos - shiftMillis * 1_000_000L;
            scene.pressSince(8 * shiftMillis, "**#**20**");
            scene.seconds(3);
            long lastKey = start + 8 * 200_000_000L;
            double millis = (scene.wheelsMovedNanos - lastKey) / 1e6;
            assertTrue(millis > 0 && millis <= 90, "wheels moved " + millis + " ms after the last key began");
        }
    }

    @Test
    void theScopeShowsTheKeyThatWasHeardLast() {
        TelephoneScene scene = called();
        assertEquals(Optional.empty(), scene.link.trace().modem().digit());
        scene.press("7");
        scene.seconds(0.06);
        assertEquals(
                DtmfKey.of('7'),
                scene.link.trace().modem().digit().orElseThrow().key());
        assertTrue(scene.link.trace().modem().isSounding());
    }

    @Test
    void aDeniedCallerHearsTwoAndIsCleared() {
        TelephoneScene scene = called("5550101");
        assertEquals("2", scene.tonesHeard.toString());
        assertTrue(scene.messagesSent().contains("Disconnect"));
        assertEquals(List.of("released robot=robot cause=16"), lines(scene, "released"));
        scene.press("**#**20**");
        scene.seconds(3);
        assertEquals(List.of(), lines(scene, "keys"));
    }

    @Test
    void aRobotThatIsOffDeniesTheCall() {
        TelephoneScene scene = new TelephoneScene();
        scene.robot.setPower(false);
        scene.dial();
        scene.seconds(0.5);
        assertEquals("2", scene.tonesHeard.toString());
        assertEquals(List.of("released robot=robot cause=16"), lines(scene, "released"));
    }

    @Test
    void aRobotSwitchedOffInTheCallDeniesTheNextOrderAndClearsOnceTheToneHasLeft() {
        TelephoneScene scene = called();
        scene.robot.setPower(false);
        scene.press("**#*0**");
        scene.seconds(2);
        assertEquals("12", scene.tonesHeard.toString());
        List<String> all = scene.lines;
        assertEquals("tone robot=robot key=2", all.get(all.size() - 2));
        assertEquals("released robot=robot cause=16", all.get(all.size() - 1));
    }

    @Test
    void aCallerWhoseSpeechStopsIsGoneAfterTwoSecondsAndTheRobotBrakes() {
        TelephoneScene scene = called();
        scene.press("**#**70**");
        scene.seconds(1.9);
        assertEquals(RobotStatus.MOVING, scene.robot.status());
        scene.fallSilent();
        scene.seconds(2.2);
        assertEquals(List.of("released robot=robot cause=41"), lines(scene, "released"));
        scene.seconds(3);
        assertEquals(RobotStatus.STOPPED, scene.robot.status());
        assertEquals("16", scene.tonesHeard.toString(), "no outcome is told");
    }

    @Test
    void hangUpIsReleasedBeforeTheStatusItCauses() {
        TelephoneScene scene = called();
        scene.press("**#**70**");
        scene.seconds(1.9);
        scene.lines.clear();
        scene.hangUp();
        scene.seconds(3);
        assertEquals(
                List.of("released robot=robot cause=16", "status robot=robot value=Stopped"),
                scene.lines.subList(0, 2));
    }

    @Test
    void whatACallIsOwedWhenItEndsIsNotHeardByTheNextCaller() {
        TelephoneScene scene = called();
        scene.press("**#**20**");
        scene.seconds(2);
        scene.holdBackNews();
        scene.hangUp();
        scene.dial();
        scene.seconds(2);
        assertEquals(RobotStatus.STOPPED, scene.robot.status(), "the first call's order ended in the second call");
        assertEquals("161", scene.tonesHeard.toString());
        scene.releaseNews();
        scene.press("**#*0**");
        scene.seconds(2);
        assertEquals("1613", scene.tonesHeard.toString());
    }

    @Test
    void aCallThatTheRobotsPowerDeniedTooLateDoesNotClearTheNextOne() {
        TelephoneScene scene = called();
        scene.press("**#**70**");
        scene.seconds(2);
        scene.holdBackNews();
        scene.hangUp();
        scene.dial();
        scene.robot.setPower(false);
        scene.seconds(1);
        assertEquals("161", scene.tonesHeard.toString());
        scene.releaseNews();
        scene.seconds(1);
        assertEquals(List.of("released robot=robot cause=16"), lines(scene, "released"), "only the hang-up");
        scene.press("**#*0**");
        scene.seconds(2.5);
        assertEquals("1612", scene.tonesHeard.toString());
        assertEquals(2, lines(scene, "released").size(), "denied and cleared once the tone has left");
    }

    @Test
    void aMinuteWithoutAKeyEndsTheCallButNotWhileAnOrderIsUnderWay() {
        TelephoneScene scene = called();
        scene.press("**#*#360**");
        scene.seconds(1.9);
        scene.seconds(50);
        assertEquals(List.of(), lines(scene, "released"));
        scene.seconds(20);
        assertEquals(List.of("released robot=robot cause=16"), lines(scene, "released"));
    }

    @Test
    void tenSecondsWithoutAKeyDropTheOrderWithSeven() {
        TelephoneScene scene = called();
        scene.press("**#");
        scene.seconds(10.3);
        assertEquals("1", scene.tonesHeard.toString());
        scene.seconds(1);
        assertEquals("17", scene.tonesHeard.toString());
    }
}
