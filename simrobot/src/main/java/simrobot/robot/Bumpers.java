package simrobot.robot;

/**
 * The pressed bumpers. Five in front and five at the rear cover 36 degrees each; numbered clockwise like the sonars,
 * the front ones from the left, the rear ones from the right.
 *
 * @param front five bits, the leftmost lowest
 * @param rear five bits, the rightmost lowest
 */
public record Bumpers(int front, int rear) {
    public static final int COUNT_EACH = 5;

    static final Bumpers NONE = new Bumpers(0, 0);

    /** Distance of the obstacle at which a bumper is released. */
    private static final double GRIP_METERS = 0.001;

    private static final double SEGMENT_RADIANS = Math.PI / COUNT_EACH;

    /** Number of tested directions: two per bumper, so that both walls of a corner are found. */
    private static final int DIRECTIONS = 4 * COUNT_EACH;

    /** The bumpers in contact with an obstacle; several in a corner. */
    static Bumpers pressed(SimulatedRobot robot, Floor floor, ContactDirection touch) {
        if (!touch.persists(robot, floor)) {
            return NONE;
        }
        int bits = bit(touch.bearing(robot.headingRadians()));
        for (int i = 0; i < DIRECTIONS; i++) {
            double direction = i * 2 * Math.PI / DIRECTIONS;
            ContactDirection felt = ContactDirection.of(
                    floor.sweep(robot, GRIP_METERS * StrictMath.cos(direction), GRIP_METERS * StrictMath.sin(direction))
                            .contact());
            if (felt.exists()) {
                bits |= bit(felt.bearing(robot.headingRadians()));
            }
        }
        return new Bumpers(bits & (1 << COUNT_EACH) - 1, bits >> COUNT_EACH);
    }

    /** Bit of the bumper in this direction: clockwise from the left, front ones first. */
    private static int bit(double bearing) {
        double clockwise = Math.PI / 2 - bearing;
        int segment = (int) Math.floor((clockwise < 0 ? clockwise + 2 * Math.PI : clockwise) / SEGMENT_RADIANS);
        return 1 << Math.min(segment, 2 * COUNT_EACH - 1);
    }
}
