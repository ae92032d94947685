package simrobot.simulation;

import simrobot.robot.Pioneer2Dx;
import simrobot.world.MovingDisc;
import simrobot.world.NearbyObstacles;

/**
 * What is known of the space around one robot: from a place where it was looked up, how far the walls and the other robots
 * are. While the robot stays clear of them by these distances, a path needs no search for contacts; the search would find
 * none.
 */
final class FreeSpace {
    /** The circle's radius, and more than a contact's gap and all rounding. */
    private static final double RIM_METERS = Pioneer2Dx.RADIUS_METERS + 4 * MovingDisc.SKIN_METERS;

    /** After a look that found no free space, the next is this many steps later. */
    private static final int PATIENCE_STEPS = 10;

    private double wallX;
    private double wallY;
    private double toWall = Double.NEGATIVE_INFINITY;
    private long wallsStep = Long.MIN_VALUE / 2;
    private double robotX;
    private double robotY;
    private double toRobot = Double.NEGATIVE_INFINITY;
    private long robotsStep = Long.MIN_VALUE / 2;
    private long robotsEpoch;

    /** The obstacles in reach of its sonars; null before the first look. */
    private NearbyObstacles obstacles;

    /** The robots in reach of its sonars. */
    private final NearbyRobots robots = new NearbyRobots();

    NearbyRobots robots() {
        return robots;
    }

    /** Forgets the walls, for a change of the world. */
    void forgetWalls() {
        toWall = Double.NEGATIVE_INFINITY;
        obstacles = null;
    }

    NearbyObstacles obstacles() {
        return obstacles;
    }

    void setObstacles(NearbyObstacles nearby) {
        obstacles = nearby;
    }

    // ---- walls ---------------------------------------------------------------------------------------------------

    void setWalls(double x, double y, double distanceMeters, long step) {
        wallX = x;
        wallY = y;
        toWall = distanceMeters;
        wallsStep = step;
    }

    /** Whether a look may help; looks are dear where the walls are close. */
    boolean mayLookForWalls(long step) {
        return step - wallsStep >= PATIENCE_STEPS;
    }

    /** Whether no wall touches the robot on the path from (x, y) by (dx, dy). */
    boolean isClearOfWalls(double x, double y, double dx, double dy) {
        return isWithin(x - wallX, y - wallY, dx, dy, toWall - RIM_METERS);
    }

    // ---- robots --------------------------------------------------------------------------------------------------

    void setRobots(double x, double y, double distanceMeters, long step, long epoch) {
        robotX = x;
        robotY = y;
        toRobot = distanceMeters;
        robotsStep = step;
        robotsEpoch = epoch;
    }

    boolean mayLookForRobots(long step) {
        return step - robotsStep >= PATIENCE_STEPS;
    }

    /**
     * Whether no robot touches this one on the path from (x, y) by (dx, dy).
     *
     * @param mostPerStep that any robot has moved in a step of this epoch
     */
    boolean isClearOfRobots(double x, double y, double dx, double dy, long step, long epoch, double mostPerStep) {
        // in the step of the look and in the present one others may have moved, or not yet
        double approached = (step - robotsStep + 1) * mostPerStep;
        return epoch == robotsEpoch
                && isWithin(
                        x - robotX, y - robotY, dx, dy, toRobot - approached - Pioneer2Dx.RADIUS_METERS - RIM_METERS);
    }

    /** Whether both ends of a path are nearer to the origin than this. */
    private static boolean isWithin(double x, double y, double dx, double dy, double meters) {
        double square = meters * meters;
        double endX = x + dx;
        double endY = y + dy;
        return meters > 0 && x * x + y * y < square && endX * endX + endY * endY < square;
    }
}
