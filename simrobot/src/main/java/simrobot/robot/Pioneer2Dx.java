package simrobot.robot;

/**
 * The robot's dimensions and limits. Metres, seconds, radians.
 *
 * <p>The origin of its pose is the centre of rotation between the driven wheels; x points ahead, y to the left.
 */
public final class Pioneer2Dx {
    /** Top speed ahead: Stage's limit for Pioneers (pioneer.inc). */
    public static final double TOP_SPEED_METERS_PER_SECOND = 0.5;

    /** Acceleration and braking: the 300 mm/s2 of the robot's own configuration packet. */
    public static final double ACCELERATION_METERS_PER_SECOND2 = 0.3;

    /** Top turning speed: Stage's limit for Pioneers, 90 degrees/s. */
    public static final double TOP_TURN_RADIANS_PER_SECOND = Math.toRadians(90);

    /** Turning acceleration and braking: the 100 degrees/s2 of the robot's own configuration packet. */
    public static final double TURN_ACCELERATION_RADIANS_PER_SECOND2 = Math.toRadians(100);

    /** The collision shape: a circle about the centre of rotation (RobotRadius 250 mm, ARIA's p2dx.p). */
    public static final double RADIUS_METERS = 0.25;

    /** Body, 44 x 38 cm (ActivMedia's data sheet, as Stage quotes it). */
    public static final double LENGTH_METERS = 0.44;

    public static final double WIDTH_METERS = 0.38;

    /** The body's middle, behind the centre of rotation (Stage, AMRISim). */
    public static final double BODY_MIDDLE_X_METERS = -0.04;

    public static final double WHEEL_DIAMETER_METERS = 0.165;
    public static final double WHEEL_WIDTH_METERS = 0.037;

    /** Distance between the wheels' middles. */
    public static final double TRACK_METERS = 0.317;

    /** Track that converts wheel speeds to the turn, slip included: 2 / DiffConvFactor 0.0056 mm of ARIA's p2dx.p. */
    public static final double EFFECTIVE_TRACK_METERS = 2 / 0.0056 / 1000;

    /** Maximum range of a sonar, also reported without an echo. */
    public static final double SONAR_RANGE_METERS = 5;

    /** Minimum range of a sonar; below it the transducer still rings from its own ping. */
    public static final double SONAR_LEAST_METERS = 0.1;

    /** The 2-DX's cone (Stage's pioneer2dx sonar). */
    public static final double SONAR_CONE_RADIANS = Math.toRadians(15);

    /** Corners of the body's octagon as shares of its half length and half width, anticlockwise (Stage's blocks). */
    private static final double[][] OCTAGON_SHARES = {
        {1, 0.12 / 0.2555},
        {0.6, 1},
        {-0.6, 1},
        {-1, 0.12 / 0.2555},
        {-1, -0.12 / 0.2555},
        {-0.6, -1},
        {0.6, -1},
        {1, -0.12 / 0.2555}
    };

    private Pioneer2Dx() {}

    /** The body as a closed octagon about the centre of rotation, anticlockwise: eight rows of x, y. */
    public static double[][] octagon() {
        double[][] corners = new double[OCTAGON_SHARES.length][];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = new double[] {
                BODY_MIDDLE_X_METERS + OCTAGON_SHARES[i][0] * LENGTH_METERS / 2, OCTAGON_SHARES[i][1] * WIDTH_METERS / 2
            };
        }
        return corners;
    }
}
