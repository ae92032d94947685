package simrobot.simulation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.Random;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import simrobot.robot.Noise;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.RobotState;
import simrobot.robot.SimulatedRobot;
import simrobot.world.Home;
import simrobot.world.ObstacleGrid;
import simrobot.world.Position;
import simrobot.world.World;

/**
 * A world, its robots and their time, which moves in fixed steps and knows no clock: the same seed and the same acts at
 * the same steps give the same poses, bit for bit. One thread owns it; {@link SimulationThread} is that thread where the
 * simulation runs at a pace, a test drives it by hand.
 */
public final class Simulation {
    public static final long STEP_NANOS = 10_000_000;

    /** With more robots than this, snapshots hold the sonars of those watched only. */
    private static final int SONARS_FOR_ALL = 16;

    private final Map<String, SimulatedRobot> byName = new HashMap<>();
    private final List<LongConsumer> stepListeners = new ArrayList<>();
    private final List<Supplier<RobotSnapshot>> guests = new ArrayList<>();
    private final Random random;
    private final SimulatedFloor crowd;
    /** In the order in which they were added; a new list at every change, so that who walks it may add and remove. */
    private List<SimulatedRobot> robots = List.of();

    private final long seed;
    private double noise;
    private World world;
    private SimulatedRobot watched;
    private long timeNanos;
    private int nextNumber;

    /** An empty floor of this world; the seed feeds {@link #random()}. */
    public Simulation(World world, long seed) {
        this.world = world;
        crowd = new SimulatedFloor(world);
        random = new Random(seed);
        this.seed = seed;
    }

    public World world() {
        return world;
    }

    /** Simulated time since the start. */
    public long timeNanos() {
        return timeNanos;
    }

    /** The one source of chance, so that a seed repeats a run. */
    public Random random() {
        return random;
    }

    /** Wheels and sonars of robots that are added from now on err so much: 0 not at all, 1 as MobileSim's, at most 10. */
    public void setNoise(double scale) {
        noise = scale;
    }

    // ---- robots --------------------------------------------------------------------------------------------------

    /** In the order in which they were added. */
    public List<SimulatedRobot> robots() {
        return robots;
    }

    public Optional<SimulatedRobot> robot(String name) {
        return Optional.ofNullable(byName.get(name));
    }

    /** Puts a robot on the first home that is free, or near the middle of the world when none is. */
    public SimulatedRobot addRobot(String name) {
        return addRobots(List.of(name)).get(0);
    }

    /** The same for many at once, in their order. */
    public List<SimulatedRobot> addRobots(List<String> names) {
        StartPlaces parking = new StartPlaces(world, (x, y) -> crowd.isFree(null, x, y));
        List<SimulatedRobot> added = new ArrayList<>(names.size());
        try {
            for (String name : names) {
                requireNew(name);
                Home spot = parking.next();
                added.add(settle(name, spot.position(), spot.headingRadians()));
            }
        } catch (NoSuchElementException full) {
            throw new IllegalStateException(
                    "no free place for robot " + names.get(added.size()) + " in " + world.name(), full);
        } finally {
            robots = Stream.concat(robots.stream(), added.stream()).toList();
        }
        return added;
    }

    /** Puts a robot exactly there. */
    public SimulatedRobot addRobot(String name, Position position, double headingRadians) {
        requireNew(name);
        if (!crowd.isFree(null, position.xMeters(), position.yMeters())) {
            throw new IllegalArgumentException("no free place for robot " + name + " at " + position.xMeters() + " "
                    + position.yMeters() + ": something is in the way there");
        }
        SimulatedRobot robot = settle(name, position, headingRadians);
        robots = Stream.concat(robots.stream(), Stream.of(robot)).toList();
        return robot;
    }

    private void requireNew(String name) {
        if (byName.containsKey(name)) {
            throw new IllegalArgumentException("robot " + name + " is there already, expected another name");
        }
    }

    /** On the floor, but not yet among {@link #robots}. */
    private SimulatedRobot settle(String name, Position position, double headingRadians) {
        SimulatedRobot robot =
                new SimulatedRobot(name, nextNumber++, crowd, position.xMeters(), position.yMeters(), headingRadians);
        robot.setNoise(new Noise(noise, seed * 31 + name.hashCode()));
        byName.put(name, robot);
        crowd.moved(robot);
        return robot;
    }

    /** Takes a robot off the floor; a motion under way is aborted. */
    public void removeRobot(SimulatedRobot robot) {
        robot.setPower(false);
        byName.remove(robot.name(), robot);
        robots = robots.stream().filter(other -> other != robot).toList();
        crowd.remove(robot);
        watched = watched == robot ? null : watched;
    }

    /**
     * Changes the world while running: every robot stands still and goes to a home.
     *
     * @throws IllegalArgumentException when the robots do not all fit into it; then nothing has changed
     */
    public void load(World next) {
        List<Home> spots = StartPlaces.spots(next, robots.size());
        robots.forEach(SimulatedRobot::halt);
        robots.forEach(crowd::remove);
        world = next;
        crowd.load(next);
        for (int i = 0; i < robots.size(); i++) {
            Home spot = spots.get(i);
            SimulatedRobot robot = robots.get(i);
            robot.place(spot.position().xMeters(), spot.position().yMeters(), spot.headingRadians());
            robot.trail().clear();
        }
    }

    /**
     * Changes the world around the robots: they stand still and stay where they are. Those who would stand in something, or
     * outside, go to homes.
     *
     * @return how many had to go
     * @throws IllegalArgumentException when these do not all fit into it; then nothing has changed
     */
    public int change(World next) {
        ObstacleGrid obstacles = new ObstacleGrid(next);
        List<SimulatedRobot> going = new ArrayList<>();
        List<Position> staying = new ArrayList<>();
        for (SimulatedRobot robot : robots) {
            double x = robot.xMeters();
            double y = robot.yMeters();
            if (next.ground().contains(x, y) && obstacles.isFree(x, y, Pioneer2Dx.RADIUS_METERS)) {
                staying.add(new Position(x, y));
            } else {
                going.add(robot);
            }
        }
        List<Home> spots = StartPlaces.spots(next, obstacles, going.size(), staying);
        robots.forEach(SimulatedRobot::halt);
        going.forEach(crowd::remove);
        world = next;
        crowd.load(next);
        for (int i = 0; i < going.size(); i++) {
            Home spot = spots.get(i);
            going.get(i).place(spot.position().xMeters(), spot.position().yMeters(), spot.headingRadians());
        }
        for (SimulatedRobot robot : robots) {
            if (!going.contains(robot)) {
                // what it had run into may be gone
                robot.place(robot.xMeters(), robot.yMeters(), robot.headingRadians());
            }
        }
        return going.size();
    }

    /** A robot that is not simulated here, but is to be seen among the others; nothing bumps into it. */
    public void addGuest(Supplier<RobotSnapshot> guest) {
        guests.add(guest);
    }

    public void removeGuest(Supplier<RobotSnapshot> guest) {
        guests.remove(guest);
    }

    // ---- time ----------------------------------------------------------------------------------------------------

    /** Told the time after each step, on the owner thread. */
    public void addStepListener(LongConsumer listener) {
        stepListeners.add(listener);
    }

    /** Moves everything on by one step. */
    public void step() {
        timeNanos += STEP_NANOS;
        for (SimulatedRobot robot : robots) {
            robot.step(STEP_NANOS);
        }
        layTrails();
        stepListeners.forEach(listener -> listener.accept(timeNanos));
    }

    private void layTrails() {
        for (SimulatedRobot robot : robots) {
            robot.trail().pass(robot.xMeters(), robot.yMeters(), timeNanos);
        }
    }

    public void run(int steps) {
        for (int i = 0; i < steps; i++) {
            step();
        }
    }

    // ---- replay --------------------------------------------------------------------------------------------------

    /** Adds robots exactly as they were, wherever that is. */
    public void restoreRobots(List<String> names, List<RobotState> states) {
        List<SimulatedRobot> restored = new ArrayList<>(names.size());
        for (int i = 0; i < names.size(); i++) {
            RobotState state = states.get(i);
            Position place = new Position(state.xMeters(), state.yMeters());
            restored.add(settle(names.get(i), place, state.headingRadians()).restore(state));
        }
        robots = Stream.concat(robots.stream(), restored.stream()).toList();
    }

    /** The robots have been restored as they were at this time. */
    public void restoredAt(long nanos) {
        timeNanos = nanos;
        layTrails();
    }

    // ---- pictures ------------------------------------------------------------------------------------------------

    /** This robot's sonars are in every snapshot, however many robots there are; null watches none. */
    public void watch(SimulatedRobot robot) {
        watched = robot;
    }

    public SimulationSnapshot snapshot() {
        return new SimulationSnapshot(
                timeNanos,
                world,
                Stream.concat(
                                robots.stream().map(this::snapshot),
                                guests.stream().map(Supplier::get))
                        .toList());
    }

    private RobotSnapshot snapshot(SimulatedRobot robot) {
        boolean sonars = robots.size() <= SONARS_FOR_ALL || robot == watched;
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
                robot.condition(),
                robot.trail().points(),
                robot.autonomy().kind(),
                true);
    }
}
