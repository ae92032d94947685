package simrobot.robot;

import simrobot.world.Cone;

/** Computes what one sonar of a robot measures; sonars that are not read cost nothing. */
final class Sonars {
    private static final double HALF_CONE_RADIANS = Pioneer2Dx.SONAR_CONE_RADIANS / 2;

    /**
     * A mouth within this distance of the robot's centre needs no look for a wall in front of it: walls stay out of the
     * collision circle, and other robots' bodies reach at most 0.04 m into it.
     */
    private static final double FREE_ARM_METERS = Pioneer2Dx.RADIUS_METERS - 0.04;

    /** One sonar in the robot's frame: mouth, its distance from the centre, and the two rays that bound its cone. */
    private record Mount(double x, double y, double arm, double leftX, double leftY, double rightX, double rightY) {
        static Mount of(int sonar) {
            double x = SonarRing.mountX(sonar);
            double y = SonarRing.mountY(sonar);
            double left = SonarRing.directionRadians(sonar) + HALF_CONE_RADIANS;
            double right = SonarRing.directionRadians(sonar) - HALF_CONE_RADIANS;
            return new Mount(
                    x,
                    y,
                    Math.sqrt(x * x + y * y),
                    StrictMath.cos(left),
                    StrictMath.sin(left),
                    StrictMath.cos(right),
                    StrictMath.sin(right));
        }
    }

    private static final Mount[] MOUNTS = new Mount[SonarRing.COUNT];

    static {
        for (int i = 0; i < MOUNTS.length; i++) {
            MOUNTS[i] = Mount.of(i);
        }
    }

    private Sonars() {}

    /**
     * The range of one sonar, 0.1 to 5 m. The rear mouths stick out of the collision circle, so a wall may stand between the
     * robot's centre and a mouth; such a sonar measures the least range.
     *
     * @param heading of the robot
     */
    static double rangeMeters(SimulatedRobot robot, Rotation heading, Floor floor, int sonar) {
        Mount mount = MOUNTS[sonar];
        double cos = heading.cos();
        double sin = heading.sin();
        double armX = mount.x * cos - mount.y * sin;
        double armY = mount.x * sin + mount.y * cos;
        double x = robot.xMeters();
        double y = robot.yMeters();
        if (mount.arm > FREE_ARM_METERS
                && floor.rayRange(robot, x, y, armX / mount.arm, armY / mount.arm, mount.arm) < mount.arm) {
            return Pioneer2Dx.SONAR_LEAST_METERS;
        }
        Cone cone = new Cone(
                x + armX,
                y + armY,
                mount.leftX * cos - mount.leftY * sin,
                mount.leftX * sin + mount.leftY * cos,
                mount.rightX * cos - mount.rightY * sin,
                mount.rightX * sin + mount.rightY * cos);
        return Math.max(Pioneer2Dx.SONAR_LEAST_METERS, floor.coneRange(robot, cone, Pioneer2Dx.SONAR_RANGE_METERS));
    }
}
