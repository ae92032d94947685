package simrobot.simulation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import simrobot.robot.Floor;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SimulatedRobot;
import simrobot.world.Area;
import simrobot.world.Cone;
import simrobot.world.Contact;
import simrobot.world.Distances;
import simrobot.world.MovingDisc;
import simrobot.world.ObstacleGrid;
import simrobot.world.Treadmill;
import simrobot.world.World;

/** The floor with all its robots; robots are found by square, so that a crowd costs each of them the same as a few. */
final class Crowd implements Floor {
    private static final double SQUARE_METERS = 1;
    private static final double RADIUS = Pioneer2Dx.RADIUS_METERS;

    private static final double[][] OCTAGON = Pioneer2Dx.octagon();

    /** No corner of the octagon is farther from the centre of rotation. */
    private static final double OCTAGON_REACH = 0.29;

    private final Map<Long, List<SimulatedRobot>> squares = new HashMap<>();
    private final Map<SimulatedRobot, Long> whereabouts = new HashMap<>();
    private List<Treadmill> treadmills = List.of();
    private ObstacleGrid obstacles;
    private Area ground;

    Crowd(World world) {
        load(world);
    }

    void load(World world) {
        obstacles = new ObstacleGrid(world);
        treadmills = world.treadmills();
        ground = world.ground();
    }

    void remove(SimulatedRobot robot) {
        Long square = whereabouts.remove(robot);
        if (square != null) {
            leave(robot, square);
        }
    }

    @Override
    public void moved(SimulatedRobot robot) {
        Long now = key(square(robot.xMeters()), square(robot.yMeters()));
        Long before = whereabouts.put(robot, now);
        if (!now.equals(before)) {
            if (before != null) {
                leave(robot, before);
            }
            squares.computeIfAbsent(now, key -> new ArrayList<>(2)).add(robot);
        }
    }

    private void leave(SimulatedRobot robot, Long square) {
        List<SimulatedRobot> there = squares.get(square);
        there.remove(robot);
        if (there.isEmpty()) {
            squares.remove(square);
        }
    }

    private static int square(double meters) {
        return (int) Math.floor(meters / SQUARE_METERS);
    }

    private static Long key(int column, int row) {
        return ((long) column << 32) | (row & 0xFFFF_FFFFL);
    }

    private void eachNear(double minX, double minY, double maxX, double maxY, Consumer<SimulatedRobot> visitor) {
        if (whereabouts.isEmpty()) {
            return;
        }
        for (int row = square(minY); row <= square(maxY); row++) {
            for (int column = square(minX); column <= square(maxX); column++) {
                squares.getOrDefault(key(column, row), List.of()).forEach(visitor);
            }
        }
    }

    @Override
    public Encounter sweep(SimulatedRobot robot, double dx, double dy) {
        double x = robot.xMeters();
        double y = robot.yMeters();
        Encounter[] first = {new Encounter(obstacles.sweep(x, y, dx, dy, RADIUS), null)};
        double reach = 2 * RADIUS + 2 * MovingDisc.SKIN_METERS;
        eachNear(
                Math.min(x, x + dx) - reach,
                Math.min(y, y + dy) - reach,
                Math.max(x, x + dx) + reach,
                Math.max(y, y + dy) + reach,
                other -> {
                    if (other != robot) {
                        first[0] = earlier(first[0], other, x, y, dx, dy);
                    }
                });
        return first[0];
    }

    private static Encounter earlier(Encounter first, SimulatedRobot other, double x, double y, double dx, double dy) {
        MovingDisc disc = new MovingDisc(x, y, dx, dy, RADIUS);
        disc.meetDisc(other.xMeters(), other.yMeters(), RADIUS);
        Contact contact = disc.contact();
        return first.contact().earlier(contact) == contact && contact.touches() ? new Encounter(contact, other) : first;
    }

    @Override
    public boolean isFree(SimulatedRobot robot, double x, double y) {
        if (!Double.isFinite(x) || !Double.isFinite(y) || obstacles.clearance(x, y, RADIUS) < RADIUS) {
            return false;
        }
        boolean[] free = {true};
        double reach = 2 * RADIUS;
        eachNear(x - reach, y - reach, x + reach, y + reach, other -> {
            if (other != robot && Math.hypot(other.xMeters() - x, other.yMeters() - y) < reach) {
                free[0] = false;
            }
        });
        return free[0];
    }

    @Override
    public boolean isInside(double x, double y) {
        return ground.contains(x, y);
    }

    @Override
    public double beltVelocityX(double x, double y) {
        double velocity = 0;
        for (Treadmill belt : treadmills) {
            velocity += belt.area().contains(x, y) ? belt.velocityX() : 0;
        }
        return velocity;
    }

    @Override
    public double beltVelocityY(double x, double y) {
        double velocity = 0;
        for (Treadmill belt : treadmills) {
            velocity += belt.area().contains(x, y) ? belt.velocityY() : 0;
        }
        return velocity;
    }

    @Override
    public double rayRange(SimulatedRobot robot, double x, double y, double ux, double uy, double range) {
        double[] nearest = {obstacles.rayRange(x, y, ux, uy, range)};
        double endX = x + range * ux;
        double endY = y + range * uy;
        eachNear(
                Math.min(x, endX) - OCTAGON_REACH,
                Math.min(y, endY) - OCTAGON_REACH,
                Math.max(x, endX) + OCTAGON_REACH,
                Math.max(y, endY) + OCTAGON_REACH,
                other -> {
                    if (other != robot) {
                        BodySide hit = (x1, y1, x2, y2) -> Distances.alongRay(x, y, ux, uy, x1, y1, x2, y2);
                        nearest[0] = Math.min(nearest[0], toBody(hit, other));
                    }
                });
        return nearest[0];
    }

    @Override
    public double coneRange(SimulatedRobot robot, Cone cone, double range) {
        double[] nearest = {obstacles.coneRange(cone, range)};
        double reach = range + OCTAGON_REACH;
        eachNear(
                cone.minX(reach) - OCTAGON_REACH,
                cone.minY(reach) - OCTAGON_REACH,
                cone.maxX(reach) + OCTAGON_REACH,
                cone.maxY(reach) + OCTAGON_REACH,
                other -> {
                    if (other != robot) {
                        nearest[0] = Math.min(nearest[0], toBody(cone::distanceToSegment, other));
                    }
                });
        return nearest[0];
    }

    /** How far it is to one side of a robot's body. */
    private interface BodySide {
        double distance(double x1, double y1, double x2, double y2);
    }

    private static double toBody(BodySide side, SimulatedRobot other) {
        double cos = Math.cos(other.headingRadians());
        double sin = Math.sin(other.headingRadians());
        double nearest = Double.POSITIVE_INFINITY;
        double[] from = OCTAGON[OCTAGON.length - 1];
        for (double[] to : OCTAGON) {
            nearest = Math.min(
                    nearest,
                    side.distance(
                            other.xMeters() + from[0] * cos - from[1] * sin,
                            other.yMeters() + from[0] * sin + from[1] * cos,
                            other.xMeters() + to[0] * cos - to[1] * sin,
                            other.yMeters() + to[0] * sin + to[1] * cos));
            from = to;
        }
        return nearest;
    }
}
