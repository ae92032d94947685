package simrobot.robot;

/**
 * The directions of a laser range finder's readings, anticlockwise from straight ahead; the first reading is the rightmost.
 *
 * @param startDegrees -180 to 180
 * @param endDegrees not below the start, at most 360 degrees from it
 * @param stepDegrees at least 0.25
 */
public record LaserField(double startDegrees, double endDegrees, double stepDegrees) {
    /** MobileSim's field: 181 readings, one per degree. */
    public static final LaserField USUAL = new LaserField(-90, 90, 1);

    /** The finest resolution of a SICK LMS 200. */
    private static final double FINEST_DEGREES = 0.25;

    public LaserField {
        boolean isFan = startDegrees >= -180 && startDegrees <= 180 && endDegrees >= startDegrees;
        if (!isFan || endDegrees - startDegrees > 360 || !(stepDegrees >= FINEST_DEGREES)) {
            throw new IllegalArgumentException("a laser from " + startDegrees + " to " + endDegrees + " degrees by "
                    + stepDegrees + ", expected a start from -180 to 180, an end after it, and at least "
                    + FINEST_DEGREES + " degrees a step");
        }
    }

    /** The number of readings. */
    public int count() {
        return (int) Math.floor((endDegrees - startDegrees) / stepDegrees + 1e-9) + 1;
    }

    /** The direction of a reading, from 0. */
    public double radians(int reading) {
        return Math.toRadians(startDegrees + reading * stepDegrees);
    }
}
