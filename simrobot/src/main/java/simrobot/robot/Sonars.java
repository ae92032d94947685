package simrobot.robot;

import simrobot.world.Cone;

/** What a robot's sonars hear. */
final class Sonars {
    private Sonars() {}

    /** Sixteen ranges, sonar 0 first. */
    static double[] rangesMeters(SimulatedRobot robot, Floor floor) {
        double[] ranges = new double[SonarRing.COUNT];
        double cos = StrictMath.cos(robot.headingRadians());
        double sin = StrictMath.sin(robot.headingRadians());
        for (int i = 0; i < ranges.length; i++) {
            double armX = SonarRing.mountX(i) * cos - SonarRing.mountY(i) * sin;
            double armY = SonarRing.mountX(i) * sin + SonarRing.mountY(i) * cos;
            ranges[i] = Math.max(Pioneer2Dx.SONAR_LEAST_METERS, range(robot, floor, i, armX, armY));
        }
        return ranges;
    }

    /**
     * One sonar whose mouth is at this offset. The rear mouths stick out of the collision circle, so a wall may stand
     * between the robot and a mouth; the sonar then presses against it and does not look through it.
     */
    private static double range(SimulatedRobot robot, Floor floor, int sonar, double armX, double armY) {
        double x = robot.xMeters();
        double y = robot.yMeters();
        double arm = Math.sqrt(armX * armX + armY * armY);
        if (floor.rayRange(robot, x, y, armX / arm, armY / arm, arm) < arm) {
            return 0;
        }
        double direction = robot.headingRadians() + SonarRing.directionRadians(sonar);
        Cone cone = new Cone(x + armX, y + armY, direction, Pioneer2Dx.SONAR_CONE_RADIANS);
        return floor.coneRange(robot, cone, Pioneer2Dx.SONAR_RANGE_METERS);
    }
}
