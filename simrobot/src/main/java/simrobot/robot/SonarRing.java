package simrobot.robot;

/** Positions and directions of the sixteen sonars (ARIA's p2dx.p), sonar 0 first, clockwise round the robot. */
public final class SonarRing {
    public static final int COUNT = 16;

    /** x, y in mm from the centre of rotation, direction in degrees anticlockwise from ahead. */
    private static final double[][] MOUNTS = {
        {69, 136, 90}, {114, 119, 50}, {148, 78, 30}, {166, 27, 10},
        {166, -27, -10}, {148, -78, -30}, {114, -119, -50}, {69, -136, -90},
        {-157, -136, -90}, {-203, -119, -130}, {-237, -78, -150}, {-255, -27, -170},
        {-255, 27, 170}, {-237, 78, 150}, {-203, 119, 130}, {-157, 136, 90}
    };

    private SonarRing() {}

    /** Position ahead of the centre of rotation, in metres. */
    public static double mountX(int sonar) {
        return MOUNTS[sonar][0] / 1000;
    }

    /** Position to the left of the centre of rotation, in metres. */
    public static double mountY(int sonar) {
        return MOUNTS[sonar][1] / 1000;
    }

    /** Direction, anticlockwise from ahead. */
    public static double directionRadians(int sonar) {
        return Math.toRadians(MOUNTS[sonar][2]);
    }
}
