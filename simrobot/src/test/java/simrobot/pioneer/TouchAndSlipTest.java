package simrobot.pioneer;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simrobot.process.BehaviourKind;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.RobotStatus;

/** A real robot's bumpers without a stall flag, and odometry that jumps. */
class TouchAndSlipTest {
    private final FakePioneer fake =
            new FakePioneer("p3dx", RobotKind.named("p3dx").orElseThrow(), FakePioneer.Manner.PROMPT, Optional.empty());

    @Test
    void aBumperThatIsPressedWhileDrivingIsACollision() {
        fake.robot.start(new Instruction.Forward(400), fake.outcomes::add);
        fake.seconds(3);
        fake.front = 0b00100;
        fake.seconds(0.3);
        assertEquals(MotionOutcome.Ending.COLLISION, fake.outcomes.get(0).ending());
        assertEquals(RobotStatus.COLLISION, fake.robot.status());
    }

    @Test
    void outOfACollisionTheRobotTurnsAlthoughItsBumperIsStillPressedAtFirst() {
        aBumperThatIsPressedWhileDrivingIsACollision();
        fake.seconds(2);
        assertEquals(
                MotionOutcome.Ending.COLLISION,
                fake.order(new Instruction.Turn(20)).ending(),
                "the way ahead is not free");
        fake.robot.start(new Instruction.Turn(90), fake.outcomes::add);
        fake.seconds(0.5);
        fake.front = 0;
        fake.seconds(5);
        assertEquals(MotionOutcome.Ending.DONE, fake.outcomes.get(2).ending());
        assertEquals(RobotStatus.STOPPED, fake.robot.status());
    }

    @Test
    void aBumperThatIsPressedAtTheRearDoesNotHinderADriveAhead() {
        fake.rear = 0b00100;
        fake.seconds(0.3);
        assertEquals(
                MotionOutcome.Ending.DONE,
                fake.order(new Instruction.Forward(50)).ending());
    }

    @Test
    void aDriveAheadWithABumperPressedThereEndsAtOnce() {
        fake.front = 0b10000;
        fake.seconds(0.3);
        MotionOutcome outcome = fake.order(new Instruction.Forward(50));
        assertEquals(MotionOutcome.Ending.COLLISION, outcome.ending());
        assertEquals(0, outcome.amountDone(), 6);
    }

    @Test
    void aProcessThatTouchesSomethingIsInCollisionAndBacksAway() {
        fake.robot.autonomy().begin(BehaviourKind.WANDER);
        fake.seconds(2);
        assertEquals(RobotStatus.MOVING, fake.robot.status());
        fake.front = 0b00100;
        fake.seconds(0.15);
        assertEquals(RobotStatus.COLLISION, fake.robot.status());
    }

    @Test
    void aJumpOfTheOdometryIsNoProgress() {
        for (double jump : List.of(500.0, -500.0, 9000.0)) {
            double x = fake.x;
            fake.robot.start(new Instruction.Forward(200), fake.outcomes::add);
            fake.seconds(2);
            fake.x += jump;
            fake.seconds(8);
            assertEquals(
                    MotionOutcome.Ending.DONE,
                    fake.outcomes.get(fake.outcomes.size() - 1).ending());
            assertEquals(2000, fake.x - jump - x, 60, "driven after a jump of " + jump);
        }
    }

    @Test
    void aHeadingThatJumpsIsNoTurn() {
        double heading = fake.heading;
        fake.robot.start(new Instruction.Turn(180), fake.outcomes::add);
        fake.seconds(1);
        fake.heading += Math.PI / 2;
        fake.seconds(5);
        assertEquals(MotionOutcome.Ending.DONE, fake.outcomes.get(0).ending());
        assertEquals(-180 + 90, Math.toDegrees(fake.heading - heading), 10);
    }
}
