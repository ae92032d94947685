package simrobot.robot;

import simrobot.world.Contact;

/**
 * Moves a robot by the turns of its wheels: along an arc in small chords, as the floor's grip and velocity carry it, up to the
 * first obstacle. The one motion under orders, processes and P2OS.
 */
final class Wheels {
    private final SimulatedRobot robot;
    private final Floor floor;
    private final Rotation direction = new Rotation();
    private final Arc arc = new Arc();

    /** Of the floor under the robot, metres in this step. */
    private double floorX;

    private double floorY;

    Wheels(SimulatedRobot robot, Floor floor) {
        this.robot = robot;
        this.floor = floor;
    }

    /** To be called at the beginning of each step. */
    void begin(double seconds) {
        floorX = floor.velocityX(robot.xMeters(), robot.yMeters()) * seconds;
        floorY = floor.velocityY(robot.xMeters(), robot.yMeters()) * seconds;
    }

    /** Moves the standing robot with the floor until an obstacle stops it; that is no collision of the robot. */
    void carry() {
        if (floorX != 0 || floorY != 0) {
            robot.advance(
                    floorX, floorY, floor.sweep(robot, floorX, floorY).contact().fraction());
        }
    }

    /**
     * Moves the robot through this step.
     *
     * @param meters with radians what the wheels turn
     * @param distanceFactor true distance per distance of the wheels
     * @param turnFactor true turn per turn of the wheels
     * @return what has stopped the robot, null for nothing
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
