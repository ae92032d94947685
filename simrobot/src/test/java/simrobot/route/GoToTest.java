package simrobot.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.concurrent.Executor;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simrobot.process.BehaviourKind;
import simrobot.process.Decision;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.Area;
import simrobot.world.ForbiddenArea;
import simrobot.world.ForbiddenLine;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.Point;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import simrobot.world.WorldBuilder;
import simrobot.world.WorldReader;
import vericommand.RobotStatus;

/** Robots that drive to places of a world. */
class GoToTest {
    /** Two rooms, joined by a door one metre wide. */
    private static WorldBuilder rooms() {
        WorldBuilder rooms = new WorldBuilder("rooms");
        rooms.add(new Segment(0, 0, 8, 0));
        rooms.add(new Segment(8, 0, 8, 4));
        rooms.add(new Segment(8, 4, 0, 4));
        rooms.add(new Segment(0, 4, 0, 0));
        rooms.add(new Segment(4, 0, 4, 2.5));
        rooms.add(new Segment(4, 3.5, 4, 4));
        return rooms;
    }

    private final List<Decision.End> ends = new ArrayList<>();
    private Simulation simulation;
    private SimulatedRobot robot;

    private void in(World world, double x, double y) {
        simulation = new Simulation(world, 1);
        robot = simulation.addRobot("robot", new Position(x, y), 0);
        robot.autonomy().addEndListener((kind, how) -> ends.add(how));
    }

    private void go(double x, double y) {
        assertTrue(robot.autonomy().begin(simulation.destinations().to(x + " " + y, new Position(x, y))));
    }

    private Decision.End awaitEnd() {
        for (int second = 0; ends.isEmpty() && second < 600; second++) {
            simulation.run(100);
        }
        assertEquals(1, ends.size(), "at " + robot.pose());
        return ends.get(0);
    }

    private void assertArrivesAt(double x, double y) {
        assertEquals(new Decision.Arrived(), awaitEnd());
        assertEquals(x, robot.xMeters(), 0.05);
        assertEquals(y, robot.yMeters(), 0.05);
        assertEquals(RobotStatus.STOPPED, robot.status());
    }

    @Test
    void itDrivesThroughTheDoorToTheOtherRoom() {
        in(rooms().build(), 1, 1);
        robot.addStatusListener(status -> assertTrue(status != RobotStatus.COLLISION));
        go(7, 1);
        simulation.run(100);
        assertFalse(simulation.snapshot().robots().get(0).path().isEmpty());
        assertArrivesAt(7, 1);
        assertTrue(simulation.snapshot().robots().get(0).path().isEmpty());
    }

    @ParameterizedTest
    @ValueSource(strings = {"maze.map", "office.map", "demo.map"})
    void itFindsItsWayBetweenAllHomesOfOurWorlds(String file) throws IOException {
        World world = WorldReader.read(Path.of("../worlds", file));
        Home first = world.items(Home.class).get(0);
        for (Home home : world.items(Home.class)) {
            ends.clear();
            in(world, first.position().xMeters(), first.position().yMeters());
            robot.addStatusListener(status -> assertTrue(status != RobotStatus.COLLISION, "at " + robot.pose()));
            BehaviourKind kind =
                    simulation.destinations().to(world, home.name()).orElseThrow();
            robot.autonomy().begin(kind);
            assertArrivesAt(home.position().xMeters(), home.position().yMeters());
            assertEquals(0, Math.IEEEremainder(robot.headingRadians() - home.headingRadians(), 2 * Math.PI), 0.05);
        }
    }

    @Test
    void itKeepsOutOfForbiddenAreasAndOffForbiddenLines() {
        WorldBuilder builder = rooms();
        Area forbidden = new Area(1.5, 0, 2.5, 2.8, 0);
        builder.add(new ForbiddenArea(forbidden));
        builder.add(new ForbiddenLine(new Segment(6, 1.2, 6, 4)));
        in(builder.build(), 1, 1);
        simulation.addStepListener(time -> {
            assertFalse(forbidden.contains(robot.xMeters(), robot.yMeters()));
            assertFalse(Math.abs(robot.xMeters() - 6) < 0.1 && robot.yMeters() > 1.2);
        });
        go(7, 3);
        assertArrivesAt(7, 3);
    }

    @ParameterizedTest
    @CsvSource({"4,1,the goal lies in an obstacle or too near to one.", "20,1,the goal lies outside the world."})
    void aGoalThatCannotBeReachedIsGivenUp(double x, double y, String why) {
        in(rooms().build(), 1, 1);
        go(x, y);
        assertEquals(new Decision.GivenUp(why), awaitEnd());
    }

    @Test
    void aGoalAtAForbiddenLineOrBehindOneSaysSo() {
        WorldBuilder builder = rooms();
        builder.add(new ForbiddenLine(new Segment(6, 0, 6, 4)));
        in(builder.build(), 1, 1);
        go(5.8, 1);
        assertEquals(
                new Decision.GivenUp(
                        "the goal lies in a forbidden area, or within 32 cm of one or of a forbidden line."),
                awaitEnd());
        ends.clear();
        go(7, 1);
        assertEquals(new Decision.GivenUp("there is no way round obstacles and forbidden places."), awaitEnd());
    }

    @Test
    void aClosedDoorMeansNoWay() {
        WorldBuilder builder = rooms();
        builder.add(new Segment(4, 2, 4, 4));
        in(builder.build(), 1, 1);
        go(7, 1);
        assertEquals(new Decision.GivenUp("there is no way."), awaitEnd());
    }

    @Test
    void aDoorThatIsClosedOnTheWayMakesItPlanAnew() {
        in(rooms().build(), 1, 1);
        go(7, 1);
        simulation.run(200);
        WorldBuilder closed = rooms();
        closed.add(new Segment(4, 2, 4, 4));
        simulation.change(closed.build());
        assertEquals(new Decision.GivenUp("there is no way."), awaitEnd());
    }

    @Test
    void aRobotInTheWayIsDrivenRound() {
        in(rooms().build(), 1, 3);
        SimulatedRobot other = simulation.addRobot("other", new Position(2.4, 3), 0);
        go(7, 3);
        assertArrivesAt(7, 3);
        assertEquals(RobotStatus.STOPPED, other.status());
    }

    @Test
    void aRobotThatStaysInTheDoorIsGivenUpAfterHalfAMinute() {
        in(rooms().build(), 1, 3);
        simulation.addRobot("other", new Position(4, 3), 0);
        go(7, 3);
        assertEquals(new Decision.GivenUp("a robot has stood in the way for 30 s."), awaitEnd());
    }

    @Test
    void aBeltThatHoldsTheRobotIsGivenUpAfterHalfAMinute() throws IOException {
        in(WorldReader.read(Path.of("../worlds", "treadmill.map")), 0, 0);
        go(3, 0);
        assertEquals(new Decision.GivenUp("the robot has come no nearer for 30 s."), awaitEnd());
        assertEquals(RobotStatus.STOPPED, robot.status());
    }

    /** Here the planner is missing, so that it fails on its own thread. */
    @Test
    void aPlanThatFailsIsGivenUp() {
        in(World.bare(), 0, 0);
        Executor plans = task -> {
            try {
                task.run();
            } catch (RuntimeException lost) {
                // as on a thread of an executor
            }
        };
        robot.autonomy()
                .begin(new BehaviourKind(
                        "goto 1 0",
                        around -> new GoTo(around, null, plans, new Position(1, 0), OptionalDouble.empty())));
        assertEquals(new Decision.GivenUp("planning a way failed."), awaitEnd());
    }

    @Test
    void robotsThatMeetPassEachOther() {
        in(World.bare(), -3, 0);
        SimulatedRobot other = simulation.addRobot("other", new Position(3, 0), Math.PI);
        List<Decision.End> others = new ArrayList<>();
        other.autonomy().addEndListener((kind, how) -> others.add(how));
        other.autonomy().begin(simulation.destinations().to("-3 0", new Position(-3, 0)));
        go(3, 0);
        for (int second = 0; (ends.isEmpty() || others.isEmpty()) && second < 200; second++) {
            simulation.run(100);
        }
        assertEquals(List.of(new Decision.Arrived()), ends);
        assertEquals(List.of(new Decision.Arrived()), others);
    }

    @Test
    void amongWanderersItArrives() {
        in(rooms().build(), 1, 1);
        for (int i = 0; i < 3; i++) {
            simulation
                    .addRobot("w" + i, new Position(2 + 1.5 * i, 3 - 2 * (i % 2)), i)
                    .autonomy()
                    .begin(BehaviourKind.WANDER);
        }
        go(7, 1);
        assertEquals(new Decision.Arrived(), awaitEnd());
    }

    @Test
    void theGoalsOfAWorldAreProcessesGoalsFirst() {
        WorldBuilder builder = rooms();
        builder.add(new Goal("Dock", "Charger", new Position(7, 3), 0));
        builder.add(new Goal("Goal", "Desk", new Position(1, 1), 0));
        builder.add(new Goal("Goal", "Desk", new Position(2, 1), 0));
        in(builder.build(), 2, 2);
        List<String> names = simulation.behaviours().kinds().stream()
                .map(BehaviourKind::text)
                .toList();
        assertEquals(List.of("wander", "wall-follow", "goto Desk", "goto Charger"), names);
        simulation.load(rooms().build());
        assertEquals(2, simulation.behaviours().kinds().size());
    }

    @Test
    void theClearanceIsTheDistanceFromTheNearestObstacle() {
        Random random = new Random(5);
        WorldBuilder builder = new WorldBuilder("points");
        List<Position> points = new ArrayList<>();
        for (int i = 0; i < 30; i++) {
            points.add(new Position(random.nextDouble() * 6, random.nextDouble() * 5));
            builder.add(new Point(points.get(i).xMeters(), points.get(i).yMeters()));
        }
        ClearanceGrid grid = new ClearanceGrid(builder.build());
        for (int i = 0; i < 300; i++) {
            double x = 1 + 4 * random.nextDouble();
            double y = 1 + 3 * random.nextDouble();
            double nearest = points.stream()
                    .mapToDouble(point -> Math.hypot(point.xMeters() - x, point.yMeters() - y))
                    .min()
                    .orElseThrow();
            assertEquals(nearest, grid.clearanceMeters(x, y), 0.075);
        }
    }
}
