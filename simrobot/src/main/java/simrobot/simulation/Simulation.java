package simrobot.simulation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.LongConsumer;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.Stream;
import simrobot.process.BehaviourList;
import simrobot.process.WaitBudget;
import simrobot.robot.LaserField;
import simrobot.robot.Noise;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.RobotState;
import simrobot.robot.SimulatedRobot;
import simrobot.route.Destinations;
import simrobot.world.Home;
import simrobot.world.ObstacleGrid;
import simrobot.world.Position;
import simrobot.world.Surface;
import simrobot.world.World;

/**
 * A world, its robots and simulated time, which advances in steps of 10 ms without a clock: the same seed and the same
 * acts at the same steps give the same poses, bit for bit. Owned by one thread: {@link SimulationThread}, or a caller
 * that steps it by hand.
 */
public final class Simulation {
    public static final long STEP_NANOS = 10_000_000;

    /** With more robots, snapshots hold the sonar ranges of the watched robot only. */
    private static final int MAX_ROBOTS_WITH_SONARS = 16;

    private final Map<String, SimulatedRobot> byName = new HashMap<>();
    private final List<LongConsumer> stepListeners = new ArrayList<>();
    private final List<Supplier<RobotSnapshot>> guests = new ArrayList<>();
    private final Random random;
    private final BehaviourList behaviours = new BehaviourList();
    private final Destinations destinations = new Destinations();
    private final SimulatedFloor floor;
    /**
     * Robots in the order of their addition; a new list at every change, so robots may be added during an iteration.
     */
    private List<SimulatedRobot> robots = List.of();

    private final long seed;
    private double noise;
    private boolean fromMiddle;
    private World world;
    private SimulatedRobot watched;
    private boolean trails = true;
    private long timeNanos;
    private int nextNumber;

    /** An empty floor of this world; the seed feeds {@link #random()}. */
    public Simulation(World world, long seed) {
        this.world = world;
        floor = new SimulatedFloor(world);
        random = new Random(seed);
        behaviours.setGoals(destinations.kinds(world));
        behaviours.setPlaces(place -> destinations.to(this.world, place));
        this.seed = seed;
    }

    public World world() {
        return world;
    }

    /** The processes of the robots; any thread may change them. */
    public BehaviourList behaviours() {
        return behaviours;
    }

    /** Makes processes that drive to a place of the world. */
    public Destinations destinations() {
        return destinations;
    }

    /** Simulated time since the start. */
    public long timeNanos() {
        return timeNanos;
    }

    /** The only source of random numbers, so that a seed repeats a run. */
    public Random random() {
        return random;
    }

    /**
     * Sets the errors of wheels, sonars and laser of robots added from now on: 0 none, 1 as in MobileSim, at most 10.
     */
    public void setNoise(double scale) {
        noise = scale;
    }

    /** Enables trails; unneeded if none is drawn. */
    public void setTrails(boolean wanted) {
        trails = wanted;
    }

    /** Makes robots added from now on to a world without homes start in its middle, not at its origin. */
    public void setStartInMiddle(boolean middle) {
        fromMiddle = middle;
    }

    // ---- robots --------------------------------------------------------------------------------------------------

    /** The robots in the order of their addition. */
    public List<SimulatedRobot> robots() {
        return robots;
    }

    public Optional<SimulatedRobot> robot(String name) {
        return Optional.ofNullable(byName.get(name));
    }

    /** Adds a robot on the first free home, or near the first home when none is free. */
    public SimulatedRobot addRobot(String name) {
        return addRobots(List.of(name)).get(0);
    }

    /** Adds several robots in their order. */
    public List<SimulatedRobot> addRobots(List<String> names) {
        StartPlaces places = new StartPlaces(world, (x, y) -> floor.isFree(null, x, y), fromMiddle);
        List<SimulatedRobot> added = new ArrayList<>(names.size());
        try {
            for (String name : names) {
                requireNew(name);
                Home place = places.next();
                added.add(create(name, place.position(), place.headingRadians()));
            }
        } catch (NoSuchElementException full) {
            throw new IllegalStateException(
                    "no free place for robot " + names.get(added.size()) + " in " + world.name(), full);
        } finally {
            robots = Stream.concat(robots.stream(), added.stream()).toList();
        }
        return added;
    }

    /** Adds a robot at this pose. */
    public SimulatedRobot addRobot(String name, Position position, double headingRadians) {
        requireNew(name);
        if (!floor.isFree(null, position.xMeters(), position.yMeters())) {
            throw new IllegalArgumentException("no free place for robot " + name + " at " + position.xMeters() + " "
                    + position.yMeters() + ": something is in the way there");
        }
        SimulatedRobot robot = create(name, position, headingRadians);
        robots = Stream.concat(robots.stream(), Stream.of(robot)).toList();
        return robot;
    }

    private void requireNew(String name) {
        if (byName.containsKey(name)) {
            throw new IllegalArgumentException("robot " + name + " is there already, expected another name");
        }
    }

    /** Puts a robot on the floor, but not yet among {@link #robots}. */
    private SimulatedRobot create(String name, Position position, double headingRadians) {
        SimulatedRobot robot =
                new SimulatedRobot(name, nextNumber++, floor, position.xMeters(), position.yMeters(), headingRadians);
        robot.setNoise(new Noise(noise, seed * 31 + name.hashCode()));
        robot.autonomy().setChoice(behaviours);
        byName.put(name, robot);
        floor.placed(robot);
        return robot;
    }

    /** Removes a robot; its motion is aborted. */
    public void removeRobot(SimulatedRobot robot) {
        robot.setPower(false);
        byName.remove(robot.name(), robot);
        robots = robots.stream().filter(other -> other != robot).toList();
        floor.remove(robot);
        watched = watched == robot ? null : watched;
    }

    /**
     * Replaces the world: every robot stops and moves to a home, its trail is cleared.
     *
     * @throws IllegalArgumentException if the robots do not all fit into it; then nothing has changed
     */
    public void load(World next) {
        replace(next, new ObstacleGrid(next), robots);
        robots.forEach(robot -> robot.trail().clear());
    }

    /**
     * Changes the world around the robots, which stop in their places. Robots that would overlap an obstacle, or be
     * outside, move to homes.
     *
     * @return the number of robots moved to homes
     * @throws IllegalArgumentException if these do not all fit into it; then nothing has changed
     */
    public int change(World next) {
        ObstacleGrid obstacles = new ObstacleGrid(next);
        List<SimulatedRobot> displaced = robots.stream()
                .filter(robot -> !next.ground().contains(robot.xMeters(), robot.yMeters())
                        || !obstacles.isFree(robot.xMeters(), robot.yMeters(), Pioneer2Dx.RADIUS_METERS))
                .toList();
        replace(next, obstacles, displaced);
        return displaced.size();
    }

    private void replace(World next, ObstacleGrid obstacles, List<SimulatedRobot> displaced) {
        Set<SimulatedRobot> leaving = new HashSet<>(displaced);
        List<SimulatedRobot> staying =
                robots.stream().filter(robot -> !leaving.contains(robot)).toList();
        List<Position> occupied = staying.stream()
                .map(robot -> new Position(robot.xMeters(), robot.yMeters()))
                .toList();
        List<Home> homes = StartPlaces.find(next, obstacles, displaced.size(), occupied);
        robots.forEach(SimulatedRobot::halt);
        displaced.forEach(floor::remove);
        world = next;
        behaviours.setGoals(destinations.kinds(next));
        floor.load(next, obstacles);
        for (int i = 0; i < homes.size(); i++) {
            Home home = homes.get(i);
            displaced.get(i).place(home.position().xMeters(), home.position().yMeters(), home.headingRadians());
        }
        // placed again, because an obstacle in contact may have been removed
        staying.forEach(robot -> robot.place(robot.xMeters(), robot.yMeters(), robot.headingRadians()));
    }

    /** Adds a robot that is not simulated but shown in snapshots; others do not collide with it. */
    public void addGuest(Supplier<RobotSnapshot> guest) {
        guests.add(guest);
    }

    public void removeGuest(Supplier<RobotSnapshot> guest) {
        guests.remove(guest);
    }

    // ---- time ----------------------------------------------------------------------------------------------------

    /** Adds a listener for the time after each step, called on the owner thread. */
    public void addStepListener(LongConsumer listener) {
        stepListeners.add(listener);
    }

    /** Advances time by 10 ms. */
    public void step() {
        timeNanos += STEP_NANOS;
        List<SimulatedRobot> moving = robots;
        floor.beginStep(moving);
        for (SimulatedRobot robot : moving) {
            robot.step(STEP_NANOS);
        }
        floor.endStep(moving);
        if (trails) {
            layTrails();
        }
        stepListeners.forEach(listener -> listener.accept(timeNanos));
    }

    private void layTrails() {
        for (SimulatedRobot robot : robots) {
            robot.trail().pass(robot.xMeters(), robot.yMeters(), timeNanos);
        }
    }

    /** Returns true if steps change nothing but the time: no simulated robot drives, no belt runs, no real robot is shown. */
    boolean isAtRest() {
        return guests.isEmpty()
                && robots.stream().allMatch(SimulatedRobot::isAtRest)
                && world.surfaces().stream().noneMatch(Surface::isMoving);
    }

    /** The wait per step of all robots, including real ones. */
    public WaitBudget waitBudget() {
        return floor.waitBudget();
    }

    public void run(int steps) {
        for (int i = 0; i < steps; i++) {
            step();
        }
    }

    // ---- replay --------------------------------------------------------------------------------------------------

    /** Adds robots in their recorded states, at any place. */
    public void restoreRobots(List<String> names, List<RobotState> states) {
        List<SimulatedRobot> restored = new ArrayList<>(names.size());
        for (int i = 0; i < names.size(); i++) {
            RobotState state = states.get(i);
            Position at = new Position(state.xMeters(), state.yMeters());
            restored.add(create(names.get(i), at, state.headingRadians()).restore(state));
        }
        robots = Stream.concat(robots.stream(), restored.stream()).toList();
    }

    /** Sets the time of the restored robots. */
    public void restoredAt(long nanos) {
        timeNanos = nanos;
        layTrails();
    }

    // ---- snapshots ------------------------------------------------------------------------------------------------

    /** Puts this robot's sonar ranges into every snapshot, whatever the number of robots; null for none. */
    public void watch(SimulatedRobot robot) {
        watched = robot;
    }

    public SimulationSnapshot snapshot() {
        return snapshot(robot -> robot.laser().isOn());
    }

    /** Returns a snapshot with the laser ranges of all robots whose sonar ranges it holds, even with lasers off. */
    public SimulationSnapshot snapshotWithLasers() {
        return snapshot(robot -> true);
    }

    /** Returns a snapshot with sonar and laser ranges of these robots, whatever the number of robots. */
    public SimulationSnapshot snapshotWithRanges(Set<String> names) {
        return snapshot(robot -> names.contains(robot.name()), robot -> names.contains(robot.name()));
    }

    private SimulationSnapshot snapshot(Predicate<SimulatedRobot> lasers) {
        return snapshot(robot -> robots.size() <= MAX_ROBOTS_WITH_SONARS || robot == watched, lasers);
    }

    private SimulationSnapshot snapshot(Predicate<SimulatedRobot> sonars, Predicate<SimulatedRobot> lasers) {
        return new SimulationSnapshot(
                timeNanos,
                world,
                Stream.concat(
                                robots.stream().map(robot -> snapshot(robot, sonars.test(robot), lasers)),
                                guests.stream().map(Supplier::get))
                        .toList(),
                behaviours.withNone(),
                behaviours.numbered(),
                behaviours.faults());
    }

    private RobotSnapshot snapshot(SimulatedRobot robot, boolean sonars, Predicate<SimulatedRobot> lasers) {
        return new RobotSnapshot(
                robot.name(),
                robot.status(),
                robot.isPowered(),
                robot.hasMotors(),
                robot.xMeters(),
                robot.yMeters(),
                robot.headingRadians(),
                robot.speedMetersPerSecond(),
                robot.turnRadiansPerSecond(),
                sonars ? robot.sonarRangesMeters() : new double[0],
                sonars && lasers.test(robot) ? robot.laser().rangesMeters(LaserField.USUAL) : new double[0],
                robot.condition(),
                robot.trail().points(),
                robot.autonomy().kind(),
                robot.autonomy().path(),
                robot.autonomy().marks(),
                true);
    }
}
