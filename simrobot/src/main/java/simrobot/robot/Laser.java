package simrobot.robot;

import java.util.stream.IntStream;
import simrobot.behaviour.Senses;

/** The laser range finder of one robot: single rays from one place, computed when read. */
public final class Laser {
    /** Maximum range, also reported without an echo: MobileSim's SICK LMS 200. */
    public static final double RANGE_METERS = 32;

    /** Ahead of the centre of rotation: LaserX of ARIA's p3dx.p. */
    public static final double MOUNT_METERS = 0.018;

    private final SimulatedRobot robot;
    private final Floor floor;
    private boolean on;

    Laser(SimulatedRobot robot, Floor floor) {
        this.robot = robot;
        this.floor = floor;
    }

    /** True if windows show the readings. */
    public boolean isOn() {
        return on;
    }

    /** Switches the display of readings; they can be read when off, too. */
    public void setOn(boolean isOn) {
        on = isOn;
    }

    /**
     * The range measured now, 0 to 32 m.
     *
     * @param reading 0 to 180, anticlockwise, 90 ahead
     */
    double rangeMeters(int reading) {
        if (reading < 0 || reading >= Senses.LASER_READINGS) {
            throw new IndexOutOfBoundsException("laser reading " + reading + ", expected 0 to 180");
        }
        return rangeMeters(LaserField.USUAL, reading);
    }

    /** The ranges measured now in the directions of a field, metres. */
    public double[] rangesMeters(LaserField field) {
        return IntStream.range(0, field.count())
                .mapToDouble(reading -> rangeMeters(field, reading))
                .toArray();
    }

    private double rangeMeters(LaserField field, int reading) {
        double heading = robot.headingRadians();
        double bearing = field.radians(reading);
        double exact = floor.rayRange(
                robot,
                robot.xMeters() + MOUNT_METERS * StrictMath.cos(heading),
                robot.yMeters() + MOUNT_METERS * StrictMath.sin(heading),
                StrictMath.cos(heading + bearing),
                StrictMath.sin(heading + bearing),
                RANGE_METERS,
                SonarClock.NOW);
        return robot.noise()
                .laser(exact, Math.round(1000 * bearing), floor.sonarClock().steps());
    }
}
