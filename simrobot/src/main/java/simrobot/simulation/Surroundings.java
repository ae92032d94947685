package simrobot.simulation;

import simrobot.world.DiscGrid;
import simrobot.world.Distances;
import simrobot.world.ObstacleGrid;

/**
 * For each of many robots what its sonars may hit: the walls and the robots that are in reach, listed once for many rays
 * and many steps. The lists hold a margin, and are made anew before anything could have come in from beyond it (Verlet's
 * lists of neighbours). Where very much is near there is no list, and rays go through the grid.
 */
final class Surroundings {
    /** Longer lists cost more than a walk through the grid. */
    private static final int ROOM = 32;

    /** How far a robot may go from where its walls were listed. */
    private static final double WALL_MARGIN_METERS = 0.5;

    /** How many steps a list of robots holds. */
    private static final int STEPS = 8;

    private static final int UNLISTED = -1;

    private final ObstacleGrid obstacles;
    private final DiscGrid discs;
    private final double[] xs;
    private final double[] ys;
    private final double reach;
    private final double robotReach;
    private final int[] walls;
    private final int[] wallCounts;
    private final double[] listedX;
    private final double[] listedY;
    private final int[] others;
    private final int[] otherCounts;

    /**
     * The surroundings of robots whose places are in these arrays.
     *
     * @param reach no sonar hits anything farther from a robot's middle
     * @param radius of the robots
     * @param step no robot goes farther in a step
     */
    Surroundings(
            ObstacleGrid obstacles,
            DiscGrid discs,
            double[] xs,
            double[] ys,
            double reach,
            double radius,
            double step) {
        this.obstacles = obstacles;
        this.discs = discs;
        this.xs = xs;
        this.ys = ys;
        this.reach = reach;
        robotReach = reach + radius + 2 * step * STEPS;
        int robots = xs.length;
        walls = new int[robots * ROOM];
        wallCounts = new int[robots];
        listedX = new double[robots];
        listedY = new double[robots];
        others = new int[robots * ROOM];
        otherCounts = new int[robots];
        java.util.Arrays.fill(listedX, Double.NaN);
    }

    /** Brings a robot's lists up to date; in every step, before its rays. */
    void look(int robot, long step) {
        double dx = xs[robot] - listedX[robot];
        double dy = ys[robot] - listedY[robot];
        if (!(dx * dx + dy * dy <= WALL_MARGIN_METERS * WALL_MARGIN_METERS)) {
            listedX[robot] = xs[robot];
            listedY[robot] = ys[robot];
            double within = reach + WALL_MARGIN_METERS;
            wallCounts[robot] = obstacles.list(xs[robot], ys[robot], within, walls, robot * ROOM, ROOM);
        }
        if (step == 0 || (step + robot) % STEPS == 0) {
            listOthers(robot);
        }
    }

    private void listOthers(int robot) {
        double x = xs[robot];
        double y = ys[robot];
        int near = discs.near(x - robotReach, y - robotReach, x + robotReach, y + robotReach);
        int count = 0;
        for (int i = 0; i < near; i++) {
            int other = discs.found(i);
            double dx = xs[other] - x;
            double dy = ys[other] - y;
            if (other != robot && dx * dx + dy * dy <= robotReach * robotReach) {
                if (count == ROOM) {
                    otherCounts[robot] = UNLISTED;
                    return;
                }
                others[robot * ROOM + count++] = other;
            }
        }
        otherCounts[robot] = count;
    }

    /** Along a ray of this robot to the first wall or robot, or {@code max}. */
    double rayRange(int robot, double x, double y, double ux, double uy, double radius, double max) {
        int from = robot * ROOM;
        double toWall = wallCounts[robot] == UNLISTED
                ? obstacles.rayRange(x, y, ux, uy, max)
                : obstacles.rayRangeAmong(walls, from, wallCounts[robot], x, y, ux, uy, max);
        if (otherCounts[robot] == UNLISTED) {
            return toRobotInCrowd(robot, x, y, ux, uy, radius, toWall);
        }
        double nearest = toWall;
        for (int i = from; i < from + otherCounts[robot]; i++) {
            double hit = Distances.alongRayToDisc(x, y, ux, uy, xs[others[i]], ys[others[i]], radius);
            nearest = hit < nearest ? hit : nearest;
        }
        return nearest;
    }

    private double toRobotInCrowd(int robot, double x, double y, double ux, double uy, double radius, double max) {
        double endX = x + max * ux;
        double endY = y + max * uy;
        int near = discs.near(
                Math.min(x, endX) - radius,
                Math.min(y, endY) - radius,
                Math.max(x, endX) + radius,
                Math.max(y, endY) + radius);
        double nearest = max;
        for (int i = 0; i < near; i++) {
            int other = discs.found(i);
            if (other != robot) {
                nearest = Math.min(nearest, Distances.alongRayToDisc(x, y, ux, uy, xs[other], ys[other], radius));
            }
        }
        return nearest;
    }
}
