package simrobot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import vericommand.RobotStatus;

/** The wall follower on real robots in rooms. */
class WallFollowTest {
    private static final List<Segment> ROOM =
            List.of(new Segment(0, 0, 6, 0), new Segment(6, 0, 6, 4), new Segment(6, 4, 0, 4), new Segment(0, 4, 0, 0));

    /** A room with a pillar that reaches in from below: two outer and two inner corners more. */
    private static final List<Segment> ROOM_WITH_PILLAR = List.of(
            new Segment(0, 0, 2.5, 0),
            new Segment(2.5, 0, 2.5, 1.2),
            new Segment(2.5, 1.2, 3.5, 1.2),
            new Segment(3.5, 1.2, 3.5, 0),
            new Segment(3.5, 0, 6, 0),
            new Segment(6, 0, 6, 4),
            new Segment(6, 4, 0, 4),
            new Segment(0, 4, 0, 0));

    private static Set<Integer> squaresVisited(List<Segment> walls, double headingDegrees) {
        Simulation simulation = new Simulation(World.of("room", walls), 1);
        SimulatedRobot robot = simulation.addRobot("robot", new Position(1.5, 2.5), Math.toRadians(headingDegrees));
        robot.addStatusListener(status -> assertTrue(status != RobotStatus.COLLISION, "collides at " + robot.pose()));
        robot.autonomy().begin(BehaviourKind.WALL_FOLLOW);
        Set<Integer> squares = new HashSet<>();
        for (int second = 0; second < 300; second++) {
            simulation.run(100);
            if (second > 60) {
                squares.add((int) robot.xMeters() * 10 + (int) robot.yMeters());
            }
        }
        return squares;
    }

    @Test
    void itGoesRoundARoomAlongAllWallsAndTouchesNone() {
        for (int heading = 0; heading < 360; heading += 45) {
            Set<Integer> squares = squaresVisited(ROOM, heading);
            assertTrue(
                    squares.containsAll(List.of(0, 10, 20, 30, 40, 50, 51, 52, 53, 43, 33, 23, 13, 3, 2, 1)),
                    heading + " degrees: " + squares);
            assertTrue(!squares.contains(21) && !squares.contains(32), heading + " degrees: " + squares);
        }
    }

    @Test
    void itFollowsTheWallRoundAPillar() {
        Set<Integer> squares = squaresVisited(ROOM_WITH_PILLAR, 0);
        assertTrue(squares.containsAll(List.of(0, 10, 21, 31, 40, 50, 53, 3)), squares.toString());
    }

    @Test
    void withNothingOnItsRightItGoesStraight() {
        Simulation simulation = new Simulation(World.bare(), 1);
        SimulatedRobot robot = simulation.addRobot("robot", new Position(0, 0), 0);
        robot.autonomy().begin(BehaviourKind.WALL_FOLLOW);
        simulation.run(1000);
        assertEquals(0, robot.yMeters(), 1e-9);
        assertTrue(robot.xMeters() > 2, "x " + robot.xMeters());
    }
}
