package simrobot.simulation;

import simrobot.robot.Pioneer2Dx;
import simrobot.world.MovingDisc;
import simrobot.world.NearbyObstacles;

/**
 * Known free space around one robot: the distances to walls and other robots from a place where they were looked up.
 * Paths within these distances need no search for contacts.
 */
final class FreeSpace {
    /** The circle's radius with a reserve for a contact's gap and rounding. */
    private static final double RIM_METERS = Pioneer2Dx.RADIUS_METERS + 4 * MovingDisc.SKIN_METERS;

    /** Steps until the next look after one that found no free space. */
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

    /** The obstacles within sonar range; null before the first look. */
    private NearbyObstacles obstacles;

    /** The robots within sonar range. */
    private final NearbyRobots robots = new NearbyRobots();

    NearbyRobots robots() {
        return robots;
    }

    /** Forgets the walls after a change of the world. */
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

    /** True if a look may help; looks are expensive near walls. */
    boolean mayLookForWalls(long step) {
        return step - wallsStep >= PATIENCE_STEPS;
    }

    /** True if no wall touches the robot on the path from (x, y) by (dx, dy). */
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
     * True if no robot touches this one on the path from (x, y) by (dx, dy).
     *
     * @param mostPerStep maximum motion of a robot in a step of this epoch
     */
    boolean isClearOfRobots(double x, double y, double dx, double dy, long step, long epoch, double mostPerStep) {
        // in the steps of the look and of this query others may or may not have moved
        double approached = (step - robotsStep + 1) * mostPerStep;
        return epoch == robotsEpoch
                && isWithin(
                        x - robotX, y - robotY, dx, dy, toRobot - approached - Pioneer2Dx.RADIUS_METERS - RIM_METERS);
    }

    /** True if both ends of a path are nearer to the origin than this. */
    private static boolean isWithin(double x, double y, double dx, double dy, double meters) {
        double square = meters * meters;
        double endX = x + dx;
        double endY = y + dy;
        return meters > 0 && x * x + y * y < square && endX * endX + endY * endY < square;
    }
}
