package simrobot.robot;

import simrobot.world.Contact;

/**
 * Moves a robot by its wheels: along an arc in small chords, with the floor's grip and velocity, up to the first
 * obstacle. Used under orders, processes and P2OS.
 */
final class Wheels {
    private final SimulatedRobot robot;
    private final Floor floor;
    private final Rotation direction = new Rotation();
    private final Arc arc = new Arc();

    /** Motion of the floor under the robot in this step, metres. */
    private double floorX;

    private double floorY;

    Wheels(SimulatedRobot robot, Floor floor) {
        this.robot = robot;
        this.floor = floor;
    }

    /** Called at the beginning of each step. */
    void begin(double seconds) {
        floorX = floor.velocityX(robot.xMeters(), robot.yMeters()) * seconds;
        floorY = floor.velocityY(robot.xMeters(), robot.yMeters()) * seconds;
    }

    /** Moves the robot at rest with the floor until an obstacle stops it; this does not count as its collision. */
    void carry() {
        if (floorX != 0 || floorY != 0) {
            robot.advance(
                    floorX, floorY, floor.sweep(robot, floorX, floorY).contact().fraction());
        }
    }

    /**
     * Moves the robot through this step.
     *
     * @param meters with radians the wheels' motion
     * @param distanceFactor true distance per distance of the wheels
     * @param turnFactor true turn per turn of the wheels
     * @return the obstacle that has stopped the robot; null for none
     */
    Floor.Encounter roll(double meters, double radians, double distanceFactor, double turnFactor) {
        double grip = floor.grip(robot.xMeters(), robot.yMeters());
        int chords = Arc.chords(meters, radians);
        double wheelTurn = radians / chords;
        double wheelDistance = meters / chords;
        double turn = wheelTurn * turnFactor * grip;
        double chord = wheelDistance * distanceFactor * grip * arc.chordShare(turn);
        for (int i = 0; i < chords; i++) {
            direction.to(robot.headingRadians() + turn / 2);
            double wheelX = chord * direction.cos();
            double wheelY = chord * direction.sin();
            double dx = wheelX + floorX / chords;
            double dy = wheelY + floorY / chords;
            Floor.Encounter encounter = dx == 0 && dy == 0 ? Floor.Encounter.NONE : floor.sweep(robot, dx, dy);
            Contact contact = encounter.contact();
            boolean stopped = contact.touches() && wheelX * contact.normalX() + wheelY * contact.normalY() < 0;
            double share = stopped ? contact.fraction() : 1;
            robot.turnBy(turn * share);
            robot.odometry().roll(wheelDistance * share, wheelTurn * share);
            robot.advance(dx, dy, contact.fraction());
            if (stopped) {
                return encounter;
            }
        }
        return null;
    }
}
