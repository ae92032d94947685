package simrobot.robot;

/** The laser range finder: single rays from one place; computed when it is read. */
public final class Laser {
    /** Maximum range, also reported without an echo: MobileSim's SICK LMS 200. */
    public static final double RANGE_METERS = 32;

    /** Ahead of the centre of rotation: LaserX of ARIA's p3dx.p. */
    public static final double MOUNT_METERS = 0.018;

    private Laser() {}

    /**
     * What a robot's laser measures now in one direction, metres.
     *
     * @param bearing from straight ahead, radians anticlockwise
     */
    static double rangeMeters(SimulatedRobot robot, Floor floor, double bearing) {
        double heading = robot.headingRadians();
        return floor.rayRange(
                robot,
                robot.xMeters() + MOUNT_METERS * StrictMath.cos(heading),
                robot.yMeters() + MOUNT_METERS * StrictMath.sin(heading),
                StrictMath.cos(heading + bearing),
                StrictMath.sin(heading + bearing),
                RANGE_METERS,
                SonarClock.NOW);
    }
}
