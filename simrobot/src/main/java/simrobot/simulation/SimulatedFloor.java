package simrobot.simulation;

import java.util.Arrays;
import java.util.List;
import simrobot.process.WaitBudget;
import simrobot.robot.Floor;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SimulatedRobot;
import simrobot.robot.SonarClock;
import simrobot.world.Area;
import simrobot.world.Cone;
import simrobot.world.Contact;
import simrobot.world.DiscGrid;
import simrobot.world.Distances;
import simrobot.world.MovingDisc;
import simrobot.world.NearbyObstacles;
import simrobot.world.ObstacleGrid;
import simrobot.world.Position;
import simrobot.world.Surface;
import simrobot.world.World;

/** The floor with its obstacles and robots. Robots are looked up by place, so the cost per robot is constant. */
final class SimulatedFloor implements Floor {
    private final WaitBudget waitBudget = new WaitBudget();
    private static final double RADIUS = Pioneer2Dx.RADIUS_METERS;

    private static final double[][] OCTAGON = Pioneer2Dx.octagon();

    /** Largest distance of the octagon's corners from the centre of rotation. */
    private static final double OCTAGON_REACH = 0.29;

    /** Largest distance of the sonars' mouths from the centre of rotation. */
    private static final double MOUTH_REACH = 0.26;

    /** Radius of the search for walls and robots. */
    private static final double LOOK_METERS = 2.5;

    /** Motion of a robot after which its list of obstacles is rebuilt. */
    private static final double LIST_SPARE_METERS = 1;

    private final DiscGrid places = new DiscGrid();
    private final SonarClock sonarClock = new SonarClock(Simulation.STEP_NANOS);

    /** Robots by their numbers; null for unused numbers. */
    private SimulatedRobot[] robots = {};

    private List<Surface> surfaces = List.of();
    private World world;
    private ObstacleGrid obstacles;
    private Area ground;

    /** The robots within laser range of {@link #seer}, looked up once for all its rays until a robot moves. */
    private final NearbyRobots inLaserReach = new NearbyRobots();

    private SimulatedRobot seer;

    /** Free spaces by the robots' numbers. */
    private FreeSpace[] spaces = {};

    private long steps;

    /** Incremented when a robot is placed, or moves farther in a step than any before. */
    private long epoch;

    /** Maximum motion of a robot in a step, with a reserve for accelerations; at first the top speed of orders. */
    private double mostPerStep = 0.006;

    SimulatedFloor(World world) {
        load(world, new ObstacleGrid(world));
    }

    /** @param grid of the same world */
    void load(World world, ObstacleGrid grid) {
        this.world = world;
        obstacles = grid;
        surfaces = world.surfaces();
        ground = world.ground();
        for (FreeSpace space : spaces) {
            space.forgetWalls();
        }
        sonarClock.renew();
    }

    @Override
    public World world() {
        return world;
    }

    @Override
    public List<Position> others(SimulatedRobot robot) {
        return Arrays.stream(robots)
                .filter(other -> other != null && other != robot)
                .map(other -> new Position(other.xMeters(), other.yMeters()))
                .toList();
    }

    @Override
    public WaitBudget waitBudget() {
        return waitBudget;
    }

    void remove(SimulatedRobot robot) {
        robots[robot.robotNumber()] = null;
        places.remove(robot.robotNumber());
        seer = null;
        epoch++;
        sonarClock.renew();
    }

    @Override
    public void moved(SimulatedRobot robot) {
        int number = robot.robotNumber();
        if (number >= robots.length) {
            robots = Arrays.copyOf(robots, Math.max(2 * robots.length, number + 1));
            int known = spaces.length;
            spaces = Arrays.copyOf(spaces, robots.length);
            for (int i = known; i < spaces.length; i++) {
                spaces[i] = new FreeSpace();
            }
        }
        robots[number] = robot;
        places.put(number, robot.xMeters(), robot.yMeters());
        seer = null;
    }

    @Override
    public void placed(SimulatedRobot robot) {
        moved(robot);
        epoch++;
        sonarClock.renew();
    }

    @Override
    public SonarClock sonarClock() {
        return sonarClock;
    }

    /**
     * Begins a step of time.
     *
     * @param moving the robots, which have not moved yet
     */
    void beginStep(List<SimulatedRobot> moving) {
        steps++;
        waitBudget.renew();
        sonarClock.begin(moving);
    }

    /** The step has ended. @param moved the robots */
    void endStep(List<SimulatedRobot> moved) {
        sonarClock.end(moved);
        waitBudget.end();
    }

    @Override
    public void stepped(double dx, double dy) {
        double square = dx * dx + dy * dy;
        if (square > mostPerStep * mostPerStep) {
            mostPerStep = 1.25 * Math.sqrt(square);
            epoch++;
        }
    }

    @Override
    public Encounter sweep(SimulatedRobot robot, double dx, double dy) {
        double x = robot.xMeters();
        double y = robot.yMeters();
        FreeSpace space = spaces[robot.robotNumber()];
        Contact wall = isClearOfWalls(space, x, y, dx, dy) ? Contact.NONE : obstacles.sweep(x, y, dx, dy, RADIUS);
        Encounter first = wall.touches() ? new Encounter(wall, null) : Encounter.NONE;
        return isClearOfRobots(space, robot, dx, dy) ? first : sweepRobots(first, robot, dx, dy);
    }

    private boolean isClearOfWalls(FreeSpace space, double x, double y, double dx, double dy) {
        if (space.isClearOfWalls(x, y, dx, dy)) {
            return true;
        }
        if (!space.mayLookForWalls(steps)) {
            return false;
        }
        space.setWalls(x, y, obstacles.clearance(x, y, LOOK_METERS), steps);
        return space.isClearOfWalls(x, y, dx, dy);
    }

    private boolean isClearOfRobots(FreeSpace space, SimulatedRobot robot, double dx, double dy) {
        double x = robot.xMeters();
        double y = robot.yMeters();
        if (space.isClearOfRobots(x, y, dx, dy, steps, epoch, mostPerStep)) {
            return true;
        }
        if (!space.mayLookForRobots(steps)) {
            return false;
        }
        space.setRobots(x, y, places.clearance(robot.robotNumber(), x, y, LOOK_METERS), steps, epoch);
        return space.isClearOfRobots(x, y, dx, dy, steps, epoch, mostPerStep);
    }

    private Encounter sweepRobots(Encounter before, SimulatedRobot robot, double dx, double dy) {
        double x = robot.xMeters();
        double y = robot.yMeters();
        Encounter first = before;
        double reach = 2 * RADIUS + 2 * MovingDisc.SKIN_METERS;
        int others = places.near(
                Math.min(x, x + dx) - reach,
                Math.min(y, y + dy) - reach,
                Math.max(x, x + dx) + reach,
                Math.max(y, y + dy) + reach);
        for (int i = 0; i < others; i++) {
            SimulatedRobot other = robots[places.found(i)];
            if (other != robot) {
                first = earlier(first, other, x, y, dx, dy);
            }
        }
        return first;
    }

    private static Encounter earlier(Encounter first, SimulatedRobot other, double x, double y, double dx, double dy) {
        MovingDisc disc = new MovingDisc(x, y, dx, dy, RADIUS);
        disc.addDisc(other.xMeters(), other.yMeters(), RADIUS);
        Contact contact = disc.contact();
        return first.contact().earlier(contact) == contact && contact.touches() ? new Encounter(contact, other) : first;
    }

    @Override
    public boolean isFree(SimulatedRobot robot, double x, double y) {
        if (!Double.isFinite(x) || !Double.isFinite(y) || !obstacles.isFree(x, y, RADIUS)) {
            return false;
        }
        return !places.isCrowded(robot == null ? -1 : robot.robotNumber(), x, y, 2 * RADIUS);
    }

    @Override
    public boolean isInside(double x, double y) {
        return ground.contains(x, y);
    }

    @Override
    public double grip(double x, double y) {
        double grip = 1;
        for (Surface surface : surfaces) {
            grip *= surface.area().contains(x, y) ? surface.grip() : 1;
        }
        return grip;
    }

    @Override
    public double velocityX(double x, double y) {
        double velocity = 0;
        for (Surface surface : surfaces) {
            velocity += surface.area().contains(x, y) ? surface.velocityX() : 0;
        }
        return velocity;
    }

    @Override
    public double velocityY(double x, double y) {
        double velocity = 0;
        for (Surface surface : surfaces) {
            velocity += surface.area().contains(x, y) ? surface.velocityY() : 0;
        }
        return velocity;
    }

    @Override
    public double rayRange(SimulatedRobot robot, double x, double y, double ux, double uy, double range, int moment) {
        double nearest = obstacles.rayRange(x, y, ux, uy, range);
        NearbyRobots others = range > Pioneer2Dx.SONAR_RANGE_METERS ? inLaserReach(robot, range) : inSonarReach(robot);
        for (int i = 0; i < others.count(); i++) {
            SimulatedRobot other = others.get(i);
            double otherX = other.sonars().xMeters(moment);
            double otherY = other.sonars().yMeters(moment);
            if (Distances.alongRayToDisc(x, y, ux, uy, otherX, otherY, OCTAGON_REACH) < nearest) {
                nearest = Math.min(
                        nearest,
                        toBody((x1, y1, x2, y2) -> Distances.alongRay(x, y, ux, uy, x1, y1, x2, y2), other, moment));
            }
        }
        return nearest;
    }

    @Override
    public double coneRange(SimulatedRobot robot, Cone cone, double range, int moment) {
        double nearest = around(robot, range, moment).coneRange(cone, range);
        NearbyRobots others = inSonarReach(robot);
        for (int i = 0; i < others.count(); i++) {
            SimulatedRobot other = others.get(i);
            if (cone.mayHold(other.sonars().xMeters(moment), other.sonars().yMeters(moment), OCTAGON_REACH, nearest)) {
                nearest = Math.min(nearest, toBody(cone::distanceToSegment, other, moment));
            }
        }
        return nearest;
    }

    /** The obstacles within reach of the robot's sonars, looked up after each metre. */
    private NearbyObstacles around(SimulatedRobot robot, double range, int moment) {
        FreeSpace space = spaces[robot.robotNumber()];
        NearbyObstacles nearby = space.obstacles();
        double reach = range + MOUTH_REACH;
        if (nearby == null
                || !nearby.covers(
                        obstacles,
                        robot.sonars().xMeters(moment),
                        robot.sonars().yMeters(moment),
                        reach)) {
            nearby = obstacles.near(robot.xMeters(), robot.yMeters(), reach + LIST_SPARE_METERS);
            space.setObstacles(nearby);
        }
        return nearby;
    }

    /** The robots that a sonar may measure at any remembered moment; looked up after as many steps. */
    private NearbyRobots inSonarReach(SimulatedRobot robot) {
        NearbyRobots nearby = spaces[robot.robotNumber()].robots();
        long most = sonarClock.rememberedSteps();
        if (!nearby.isValid(steps, most, epoch)) {
            // both robots may move for the remembered time before and after the look
            double moved = 2 * (most + 1) * mostPerStep;
            lookUp(nearby, robot, Pioneer2Dx.SONAR_RANGE_METERS + moved);
        }
        return nearby;
    }

    private NearbyRobots inLaserReach(SimulatedRobot robot, double range) {
        if (seer != robot) {
            lookUp(inLaserReach, robot, range);
            seer = robot;
        }
        return inLaserReach;
    }

    private void lookUp(NearbyRobots nearby, SimulatedRobot robot, double range) {
        double x = robot.xMeters();
        double y = robot.yMeters();
        double around = range + MOUTH_REACH + OCTAGON_REACH;
        int found = places.near(x - around, y - around, x + around, y + around);
        nearby.clear(steps, epoch);
        for (int i = 0; i < found; i++) {
            SimulatedRobot other = robots[places.found(i)];
            if (other != robot) {
                nearby.add(other);
            }
        }
    }

    /** The distance to one side of a robot's body. */
    private interface BodySide {
        double distance(double x1, double y1, double x2, double y2);
    }

    private static double toBody(BodySide side, SimulatedRobot other, int moment) {
        double x = other.sonars().xMeters(moment);
        double y = other.sonars().yMeters(moment);
        double cos = Math.cos(other.sonars().headingRadians(moment));
        double sin = Math.sin(other.sonars().headingRadians(moment));
        double nearest = Double.POSITIVE_INFINITY;
        double[] from = OCTAGON[OCTAGON.length - 1];
        for (double[] to : OCTAGON) {
            nearest = Math.min(
                    nearest,
                    side.distance(
                            x + from[0] * cos - from[1] * sin,
                            y + from[0] * sin + from[1] * cos,
                            x + to[0] * cos - to[1] * sin,
                            y + to[0] * sin + to[1] * cos));
            from = to;
        }
        return nearest;
    }
}
