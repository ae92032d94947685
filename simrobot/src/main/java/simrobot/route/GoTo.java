package simrobot.route;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicReference;
import simrobot.behaviour.Senses;
import simrobot.behaviour.Steering;
import simrobot.process.Decision;
import simrobot.process.RobotProcess;
import simrobot.process.Surroundings;
import simrobot.world.Position;
import simrobot.world.World;

/**
 * Drives to a place: plans a path, follows it, and replans after a change of the world, after a collision, and when
 * another robot has blocked it for 1 to 3 s. Gives up if no path exists, if the path is blocked for 30 s, or without
 * progress for 30 s, as on a treadmill.
 */
public final class GoTo implements RobotProcess {
    private static final Logger LOG = System.getLogger(GoTo.class.getName());
    private static final double METERS_PER_SECOND = 0.4;
    private static final double RADIANS_PER_SECOND = Math.toRadians(60);

    /** Distance of the target point ahead on the path. */
    private static final double AHEAD_METERS = 0.3;

    /** Angle above which it turns on the spot. */
    private static final double SPOT_RADIANS = Math.toRadians(20);

    private static final double ARRIVED_METERS = 0.03;
    private static final double ARRIVED_RADIANS = Math.toRadians(1);

    /** Distance of another robot's middle at which the path is blocked: two radii and 5 cm. */
    private static final double BLOCKING_METERS = 2 * 0.25 + 0.05;

    /** Range of the search for other robots ahead. */
    private static final double LOOK_METERS = 1.2;

    private static final int TICKS_PER_SECOND = (int) (1_000_000_000 / TICK_NANOS);
    private static final int PATIENCE_TICKS = 30 * TICKS_PER_SECOND;
    private static final double NEARER_METERS = 0.01;
    private static final int MOST_COLLISIONS = 5;
    private static final Decision STAND = new Decision.Go(Steering.STOP);

    private final Surroundings surroundings;
    private final RoutePlanner planner;
    private final Executor executor;
    private final Position goal;
    private final OptionalDouble headingRadians;
    private final AtomicReference<RoutePlanner.Plan> planned = new AtomicReference<>();

    /** The world of the plan; null before the first. */
    private World world;

    private boolean planning;
    /** The rest of the path, next position first. */
    private List<Position> way = List.of();

    private Position legStart;
    private int blockedTicks;
    /** Shortest remaining distance so far; time without progress. */
    private double leastLeftMeters;

    private int stalledTicks;
    private int backingTicks;
    private int collisions;
    private boolean atGoal;
    private double nearest = Double.POSITIVE_INFINITY;

    /** @param executor plans, possibly at once on this thread */
    public GoTo(
            Surroundings surroundings,
            RoutePlanner planner,
            Executor executor,
            Position goal,
            OptionalDouble headingRadians) {
        this.surroundings = surroundings;
        this.planner = planner;
        this.executor = executor;
        this.goal = goal;
        this.headingRadians = headingRadians;
    }

    @Override
    public List<Position> path() {
        return way;
    }

    @Override
    public Decision decide(Senses senses) {
        Position here = new Position(senses.xMeters(), senses.yMeters());
        if (senses.isBlocked() && backingTicks == 0) {
            if (++collisions > MOST_COLLISIONS) {
                return new Decision.Collided();
            }
            backingTicks = TICKS_PER_SECOND;
            world = null;
        }
        if (backingTicks > 0) {
            backingTicks--;
            boolean front = senses.nearestMeters(0, 7) <= senses.nearestMeters(8, 15);
            return new Decision.Go(new Steering(front ? -0.15 : 0.15, 0));
        }
        if (surroundings.world() != world && !planning) {
            plan(here, List.of());
        }
        RoutePlanner.Plan plan = planned.getAndSet(null);
        if (plan != null) {
            planning = false;
            if (!plan.isFound() && blockedTicks == 0) {
                return new Decision.GivenUp(plan.refusal() + ".");
            }
            way = plan.isFound() ? plan.way() : way;
            legStart = here;
            leastLeftMeters = leftMeters(here);
        }
        if (way.isEmpty()) {
            return STAND;
        }
        return isBlockedByRobot(here) ? await(here) : follow(senses, here);
    }

    private void plan(Position from, List<Position> robots) {
        planning = true;
        atGoal = false;
        nearest = Double.POSITIVE_INFINITY;
        World here = surroundings.world();
        world = here;
        executor.execute(() -> planned.set(planned(here, from, robots)));
    }

    /** Counts a failed plan as none, even an OutOfMemoryError in a large world; else the robot would stay Moving. */
    private RoutePlanner.Plan planned(World here, Position from, List<Position> robots) {
        try {
            return planner.plan(here, from, goal, robots);
        } catch (RuntimeException | OutOfMemoryError fault) {
            LOG.log(Level.ERROR, "planning a way failed", fault);
            return RoutePlanner.Plan.none("planning a way failed");
        }
    }

    private double leftMeters(Position here) {
        double left = 0;
        Position from = here;
        for (Position next : way) {
            left += distance(from, next);
            from = next;
        }
        return left;
    }

    /** Counts the time without 1 cm of progress along the path. */
    private boolean isStalled(Position here) {
        double left = leftMeters(here);
        stalledTicks = left < leastLeftMeters - NEARER_METERS ? 0 : stalledTicks + 1;
        leastLeftMeters = stalledTicks == 0 ? left : leastLeftMeters;
        return stalledTicks > PATIENCE_TICKS;
    }

    private Decision await(Position here) {
        blockedTicks++;
        if (blockedTicks > PATIENCE_TICKS) {
            return new Decision.GivenUp("a robot has stood in the way for 30 s.");
        }
        // staggered, so that robots that block each other do not plan at the same time
        int wait = TICKS_PER_SECOND * (1 + surroundings.robotNumber() % 3);
        if (blockedTicks % wait == 0 && !planning) {
            plan(here, surroundings.otherRobots());
        }
        return STAND;
    }

    private boolean isBlockedByRobot(Position here) {
        List<Position> others = surroundings.otherRobots();
        if (others.isEmpty()) {
            return false;
        }
        List<Position> legs = new ArrayList<>(List.of(here));
        legs.addAll(way);
        double left = LOOK_METERS;
        for (int i = 1; i < legs.size() && left > 0; i++) {
            double length = distance(legs.get(i - 1), legs.get(i));
            for (Position other : others) {
                if (isNear(other, legs.get(i - 1), legs.get(i), Math.min(length, left), here)) {
                    return true;
                }
            }
            left -= length;
        }
        return false;
    }

    /** True if a leg, within the search range, is nearer to the robot than its start and than permitted. */
    private static boolean isNear(Position other, Position from, Position to, double look, Position here) {
        double length = distance(from, to);
        double end = length == 0 ? 0 : look / length;
        double dx = to.xMeters() - from.xMeters();
        double dy = to.yMeters() - from.yMeters();
        double along = length == 0
                ? 0
                : ((other.xMeters() - from.xMeters()) * dx + (other.yMeters() - from.yMeters()) * dy)
                        / (length * length);
        double share = Math.max(0, Math.min(end, along));
        double gap = Math.hypot(
                from.xMeters() + share * dx - other.xMeters(), from.yMeters() + share * dy - other.yMeters());
        return gap < BLOCKING_METERS && gap < distance(other, here) - 1e-6;
    }

    private Decision follow(Senses senses, Position here) {
        blockedTicks = 0;
        while (way.size() > 1 && hasPassed(here)) {
            legStart = way.get(0);
            way = way.subList(1, way.size());
        }
        if (isStalled(here)) {
            return new Decision.GivenUp("the robot has come no nearer for 30 s.");
        }
        double left = distance(here, goal);
        boolean last = way.size() == 1;
        atGoal |= last && (left < ARRIVED_METERS || left < 0.15 && left > nearest + 0.01);
        nearest = last ? Math.min(nearest, left) : nearest;
        if (atGoal) {
            return turnAtGoal(senses);
        }
        Position to = target(here);
        double error = angle(
                Math.atan2(to.yMeters() - here.yMeters(), to.xMeters() - here.xMeters()) - senses.headingRadians());
        double turn = limited(2 * error);
        if (Math.abs(error) > SPOT_RADIANS) {
            return new Decision.Go(new Steering(0, turn));
        }
        double speed = last ? Math.max(0.04, Math.min(METERS_PER_SECOND, 0.6 * left)) : METERS_PER_SECOND;
        return new Decision.Go(new Steering(speed, turn));
    }

    private Decision turnAtGoal(Senses senses) {
        if (headingRadians.isEmpty()) {
            return new Decision.Arrived();
        }
        double error = angle(headingRadians.getAsDouble() - senses.headingRadians());
        return Math.abs(error) < ARRIVED_RADIANS
                ? new Decision.Arrived()
                : new Decision.Go(new Steering(0, limited(1.5 * error)));
    }

    private static double limited(double turn) {
        return Math.max(-RADIANS_PER_SECOND, Math.min(RADIANS_PER_SECOND, turn));
    }

    private boolean hasPassed(Position here) {
        Position end = way.get(0);
        double dx = end.xMeters() - legStart.xMeters();
        double dy = end.yMeters() - legStart.yMeters();
        double beyond = (here.xMeters() - end.xMeters()) * dx + (here.yMeters() - end.yMeters()) * dy;
        return beyond >= 0 || distance(here, end) < 0.1;
    }

    /** The point of the current leg a little ahead of the robot. */
    private Position target(Position here) {
        Position end = way.get(0);
        double length = distance(legStart, end);
        if (length == 0) {
            return end;
        }
        double dx = (end.xMeters() - legStart.xMeters()) / length;
        double dy = (end.yMeters() - legStart.yMeters()) / length;
        double along = (here.xMeters() - legStart.xMeters()) * dx + (here.yMeters() - legStart.yMeters()) * dy;
        double ahead = Math.min(length, along + AHEAD_METERS);
        return new Position(legStart.xMeters() + ahead * dx, legStart.yMeters() + ahead * dy);
    }

    private static double distance(Position a, Position b) {
        return Math.hypot(a.xMeters() - b.xMeters(), a.yMeters() - b.yMeters());
    }

    private static double angle(double radians) {
        return Math.atan2(Math.sin(radians), Math.cos(radians));
    }
}
