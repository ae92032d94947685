package simrobot.simulation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simrobot.process.BehaviourKind;
import simrobot.robot.RobotState;
import simrobot.robot.SimulatedRobot;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;
import simrobot.world.WorldBuilder;
import simrobot.world.WorldReader;
import vericommand.Instruction;
import vericommand.MotionOutcome;
import vericommand.RobotStatus;

class SimulationTest {
    private static World office() throws Exception {
        return WorldReader.read(Path.of("..", "worlds", "office.map"));
    }

    @Test
    void timeMovesInStepsOfTenMilliseconds() {
        Simulation simulation = new Simulation(World.bare(), 1);
        List<Long> told = new ArrayList<>();
        simulation.addStepListener(told::add);
        simulation.run(3);
        assertEquals(30_000_000, simulation.timeNanos());
        assertEquals(List.of(10_000_000L, 20_000_000L, 30_000_000L), told);
    }

    @Test
    void itIsAtRestUntilARobotIsToMove() {
        Simulation simulation = new Simulation(World.bare(), 1);
        SimulatedRobot robot = simulation.addRobot("robot");
        assertTrue(simulation.isAtRest());
        robot.start(new Instruction.Forward(20), ended -> {});
        assertFalse(simulation.isAtRest());
        simulation.run(500);
        assertTrue(simulation.isAtRest());
        robot.autonomy().begin(BehaviourKind.WANDER);
        assertFalse(simulation.isAtRest());
        robot.brake();
        simulation.run(500);
        assertTrue(simulation.isAtRest());
        simulation.addGuest(() -> null);
        assertFalse(simulation.isAtRest());
    }

    @Test
    void robotsStandOnTheHomesInTheirOrder() throws Exception {
        World world = office();
        Simulation simulation = new Simulation(world, 1);
        for (int i = 0; i < world.items(Home.class).size(); i++) {
            SimulatedRobot robot = simulation.addRobot("r" + i);
            Position home = world.items(Home.class).get(i).position();
            assertEquals(home, new Position(robot.xMeters(), robot.yMeters()));
        }
        SimulatedRobot oneMore = simulation.addRobot("more");
        assertTrue(world.bounds().contains(oneMore.xMeters(), oneMore.yMeters()));
    }

    @Test
    void thirtyRobotsOfAClassDriveTwentyCentimetresFromTheirPlacesAtOnce() throws Exception {
        Simulation simulation = new Simulation(office(), 1);
        for (int i = 0; i < 30; i++) {
            simulation.addRobot("r" + i).start(new Instruction.Forward(20), ended -> {});
        }
        simulation.run(500);
        for (SimulatedRobot robot : simulation.robots()) {
            assertEquals(RobotStatus.STOPPED, robot.status(), robot.name());
        }
    }

    @Test
    void withoutAHomeTheRobotStandsAtTheOriginOrNextToIt() {
        Simulation simulation = new Simulation(World.bare(), 1);
        assertEquals(0, simulation.addRobot("a").xMeters());
        assertEquals(0.75, Math.abs(simulation.addRobot("b").yMeters()));
    }

    @Test
    void theMiddleOfALargeBoxIsNoPlaceToStart() {
        World world = new WorldBuilder("hall")
                .add(new Box("Stage", new Area(-3, -3, 3, 3, 0)))
                .add(new Segment(-8, -8, 8, -8))
                .add(new Segment(-8, 8, 8, 8))
                .build();
        Simulation simulation = new Simulation(world, 1);
        for (String name : List.of("a", "b")) {
            SimulatedRobot robot = simulation.addRobot(name);
            assertTrue(
                    Math.max(Math.abs(robot.xMeters()), Math.abs(robot.yMeters())) > 3,
                    robot.xMeters() + ", " + robot.yMeters());
        }
    }

    @Test
    void twoRobotsOfOneNameAreRefusedAndSoIsAnOccupiedPlace() {
        Simulation simulation = new Simulation(World.bare(), 1);
        simulation.addRobot("a");
        assertThrows(IllegalArgumentException.class, () -> simulation.addRobot("a"));
        assertThrows(IllegalArgumentException.class, () -> simulation.addRobot("b", new Position(0.1, 0), 0));
    }

    @Test
    void aNewWorldAbortsMotionsAndTakesRobotsHome() throws Exception {
        Bench bench = Bench.onBareFloor().forward(500).seconds(2);
        bench.simulation.load(office());
        assertEquals(MotionOutcome.Ending.ABORTED, bench.outcomes.get(0).ending());
        assertEquals(RobotStatus.STOPPED, bench.robot.status());
        assertEquals(9, bench.robot.xMeters());
        assertEquals(MotionOutcome.Ending.DONE, bench.forward(100).untilEnded().ending());
    }

    // ---- chance and repetition -----------------------------------------------------------------------------------

    private static long[] run(long seed) throws Exception {
        Simulation simulation = new Simulation(office(), seed);
        for (int i = 0; i < 8; i++) {
            simulation.addRobot("r" + i);
        }
        for (int step = 0; step < 4000; step++) {
            for (SimulatedRobot robot : simulation.robots()) {
                if (robot.status() == RobotStatus.STOPPED || robot.status() == RobotStatus.COLLISION) {
                    boolean turn = robot.status() == RobotStatus.COLLISION
                            || simulation.random().nextBoolean();
                    robot.start(
                            turn
                                    ? new Instruction.Turn(
                                            1 + simulation.random().nextInt(360))
                                    : new Instruction.Forward(
                                            1 + simulation.random().nextInt(300)),
                            ended -> {});
                }
            }
            simulation.step();
        }
        return simulation.robots().stream()
                .flatMapToLong(robot -> java.util.stream.LongStream.of(
                        Double.doubleToLongBits(robot.xMeters()),
                        Double.doubleToLongBits(robot.yMeters()),
                        Double.doubleToLongBits(robot.headingRadians())))
                .toArray();
    }

    private static List<RobotState> wandering(long seed) throws Exception {
        Simulation simulation = new Simulation(office(), seed);
        simulation.setNoise(1);
        for (int i = 0; i < 6; i++) {
            simulation.addRobot("r" + i).autonomy().begin(i < 4 ? BehaviourKind.WANDER : BehaviourKind.WALL_FOLLOW);
        }
        simulation.run(6000);
        return simulation.robots().stream().map(SimulatedRobot::state).toList();
    }

    @Test
    void aSeedRepeatsErringWheelsAndTheProcessesThatSteerThem() throws Exception {
        List<RobotState> first = wandering(42);
        assertEquals(first, wandering(42));
        assertNotEquals(first, wandering(43));
    }

    @Test
    void theSameSeedAndActsGiveTheSamePosesBitForBit() throws Exception {
        long[] first = run(42);
        assertArrayEquals(first, run(42));
        assertNotEquals(java.util.Arrays.hashCode(first), java.util.Arrays.hashCode(run(43)));
    }

    // ---- sonar ---------------------------------------------------------------------------------------------------

    @Test
    void sonarsHearNothingInTheMiddleOfTheEmptyHall() throws Exception {
        Simulation simulation = new Simulation(WorldReader.read(Path.of("..", "worlds", "empty.map")), 1);
        for (int range : simulation.addRobot("robot").sonarRangesMillimeters()) {
            assertEquals(5000, range);
        }
    }

    @Test
    void sonarsMeasureFromWhereTheySit() {
        Bench bench = Bench.withWalls(new Segment(-9, 1, 9, 1), new Segment(2, -9, 2, 9));
        int[] ranges = bench.robot.sonarRangesMillimeters();
        assertEquals(1000 - 136, ranges[0]);
        assertEquals(1000 - 136, ranges[15]);
        // sonars 3 and 4 look 10 degrees aside; the cone's edge is 2.5 degrees from the wall's normal
        assertEquals(Math.round((2000 - 166) / Math.cos(Math.toRadians(2.5))), ranges[3]);
        assertEquals(ranges[3], ranges[4]);
        assertEquals(5000, ranges[7]);
        assertEquals(5000, ranges[11]);
    }

    @Test
    void sonarsTurnWithTheRobot() {
        Bench bench = new Bench(World.of("wall", List.of(new Segment(-9, -1, 9, -1))), 0, 0, 180);
        int[] ranges = bench.robot.sonarRangesMillimeters();
        assertEquals(1000 - 136, ranges[0]);
        assertEquals(5000, ranges[7]);
    }

    @Test
    void whatIsNearerThanTenCentimetresReadsTenCentimetres() {
        Bench bench = Bench.withWalls(new Segment(-9, 0.2501, 9, 0.2501), new Segment(-0.2501, -9, -0.2501, 9));
        int[] ranges = bench.robot.sonarRangesMillimeters();
        assertEquals(114, ranges[0]);
        // sonars 11 and 12 stick out of the collision circle; a wall behind their mouths is as near as can be
        assertEquals(100, ranges[11]);
        assertEquals(100, ranges[12]);
    }

    @Test
    void robotsHearEachOthersBodies() {
        Bench bench = Bench.onBareFloor();
        bench.simulation.addRobot("other", new Position(0, 1), 0);
        assertEquals(1000 - 136 - 190, bench.robot.sonarRangesMillimeters()[0], 1);
        assertEquals(5000, bench.robot.sonarRangesMillimeters()[7]);
    }

    // ---- pictures ------------------------------------------------------------------------------------------------

    @Test
    void aSnapshotDoesNotChangeWhenTheRobotMovesOn() {
        Bench bench = Bench.onBareFloor().forward(100).seconds(2);
        SimulationSnapshot before = bench.simulation.snapshot();
        double x = before.robots().get(0).xMeters();
        int points = before.robots().get(0).trail().size();
        bench.seconds(1);
        assertEquals(x, before.robots().get(0).xMeters());
        assertEquals(points, before.robots().get(0).trail().size());
        assertTrue(bench.simulation.snapshot().robots().get(0).trail().size() > points);
    }

    @Test
    void aTrailForgetsItsOldestCrumbs() {
        Bench bench = Bench.onBareFloor();
        for (int i = 0; i < 60; i++) {
            bench.forward(200).untilEnded();
        }
        double[] xy = bench.robot.trail().points().xy();
        assertEquals(2 * 4000, xy.length);
        assertEquals(120, xy[xy.length - 2], 0.03);
        assertTrue(xy[0] > 5);
    }

    @Test
    void inACrowdOnlyTheWatchedRobotsSonarsAreInThePicture() {
        Simulation simulation = new Simulation(World.bare(), 1);
        for (int i = 0; i < 20; i++) {
            simulation.addRobot("r" + i);
        }
        simulation.watch(simulation.robots().get(3));
        SimulationSnapshot picture = simulation.snapshot();
        assertEquals(0, picture.robots().get(0).sonarRangesMeters().length);
        assertEquals(16, picture.robots().get(3).sonarRangesMeters().length);
    }

    @Test
    void aChangedWorldLeavesRobotsWhereTheyFitAndSendsTheOthersHome() {
        Simulation office = new Simulation(World.of("a", List.of(new Segment(-5, -5, 5, 5))), 1);
        SimulatedRobot stays = office.addRobot("stays", new Position(3, 0), 1);
        SimulatedRobot goes = office.addRobot("goes", new Position(-3, 0), 2);
        stays.start(new Instruction.Forward(500), ended -> {});
        office.run(50);
        double x = stays.xMeters();
        World next = World.of("b", List.of(new Segment(-5, 0, -1, 0), new Segment(-5, 5, 5, -5))).toBuilder()
                .add(new Home("h", new Position(-4, 2), 0.5, Optional.empty()))
                .build();
        assertEquals(1, office.change(next));
        assertEquals(x, stays.xMeters());
        assertEquals(RobotStatus.STOPPED, stays.status());
        assertEquals(-4, goes.xMeters());
        assertEquals(2, goes.yMeters());
        assertEquals(0.5, goes.headingRadians());
        assertEquals(next, office.world());
    }
}
