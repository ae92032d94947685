package simrobot.robot;

/**
 * Which bumpers are pressed. Five in front and five behind share the round evenly; like the sonars they count clockwise,
 * the front ones from the left, the rear ones from the right.
 *
 * @param front five bits, the leftmost lowest
 * @param rear five bits, the rightmost lowest
 */
public record Bumpers(int front, int rear) {
    public static final int COUNT_EACH = 5;

    static final Bumpers NONE = new Bumpers(0, 0);

    /** A bumper lets go within this way. */
    private static final double GRIP_METERS = 0.001;

    private static final double SEGMENT_RADIANS = Math.PI / COUNT_EACH;

    /** Half a bumper, so that in a corner each of the two walls is the nearest of some feeler. */
    private static final int FEELERS = 4 * COUNT_EACH;

    /** All that presses on the robot, felt for all round; in a corner more than one. */
    static Bumpers pressed(SimulatedRobot robot, Floor floor, ContactDirection touch) {
        if (!touch.holds(robot, floor)) {
            return NONE;
        }
        int bits = bit(touch.bearing(robot.headingRadians()));
        for (int i = 0; i < FEELERS; i++) {
            double direction = i * 2 * Math.PI / FEELERS;
            ContactDirection felt = ContactDirection.of(
                    floor.sweep(robot, GRIP_METERS * StrictMath.cos(direction), GRIP_METERS * StrictMath.sin(direction))
                            .contact());
            if (felt.isSomething()) {
                bits |= bit(felt.bearing(robot.headingRadians()));
            }
        }
        return new Bumpers(bits & (1 << COUNT_EACH) - 1, bits >> COUNT_EACH);
    }

    /** Clockwise all round from the left, front ones first. */
    private static int bit(double bearing) {
        double clockwise = Math.PI / 2 - bearing;
        int segment = (int) Math.floor((clockwise < 0 ? clockwise + 2 * Math.PI : clockwise) / SEGMENT_RADIANS);
        return 1 << Math.min(segment, 2 * COUNT_EACH - 1);
    }

    public boolean isPressed() {
        return front != 0 || rear != 0;
    }
}
