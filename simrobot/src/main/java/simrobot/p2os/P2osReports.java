package simrobot.p2os;

import java.util.List;
import simrobot.robot.Bumpers;
import simrobot.robot.Odometry;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import vericommand.Pose;

/** What a robot tells its client about itself, packet by packet. */
final class P2osReports {
    private static final int INTRODUCTION_ID = 2;
    private static final int ENCODER_ID = 0x90;
    private static final int SIMULATOR_ID = 0x62;

    /** Player has room for 19 bytes. */
    private static final int NAME_LENGTH = 19;

    private final SimulatedRobot robot;
    private final StallDetector stall;
    private boolean sonarOn = true;
    private List<Integer> polled = P2osSession.allSonars();

    P2osReports(SimulatedRobot robot, StallDetector stall) {
        this.robot = robot;
        this.stall = stall;
    }

    void setSonar(boolean on) {
        sonarOn = on;
    }

    /** @param sonars those that are fired; none given means all */
    void setPolled(List<Integer> sonars) {
        polled = sonars.isEmpty()
                ? P2osSession.allSonars()
                : sonars.stream().distinct().sorted().toList();
    }

    /** The robot's name as its clients can take it. */
    String name() {
        String plain = robot.name().replaceAll("[^ -~]", "?");
        return plain.substring(0, Math.min(NAME_LENGTH, plain.length()));
    }

    byte[] introduction() {
        return P2osPacket.of(P2osPacket.data()
                .octet(INTRODUCTION_ID)
                .zeroEnded(name())
                .zeroEnded(P3dxScale.CLASS)
                .zeroEnded(P3dxScale.SUBCLASS)
                .toArray());
    }

    byte[] standard(long simulatedNanos) {
        Odometry odometry = robot.odometry();
        double speed = robot.speedMetersPerSecond();
        double turn = robot.turnRadiansPerSecond();
        double half = turn * Pioneer2Dx.EFFECTIVE_TRACK_METERS / 2;
        int[] sonars = sonarOn ? polled.stream().mapToInt(Integer::intValue).toArray() : new int[0];
        Bumpers bumpers = robot.bumpers();
        return new StandardSip(
                        speed != 0 || turn != 0,
                        P3dxScale.place(odometry.xMeters()),
                        P3dxScale.place(odometry.yMeters()),
                        P3dxScale.angle(odometry.headingRadians()),
                        P3dxScale.millimeters(speed - half),
                        P3dxScale.millimeters(speed + half),
                        (int) Math.round(robot.battery().volts() * 10),
                        (int) Math.round(robot.battery().chargeShare() * 100),
                        stall.isNoticed(bumpers, simulatedNanos),
                        bumpers.front(),
                        bumpers.rear(),
                        P3dxScale.angle(
                                odometry.headingRadians() + robot.drive().remainingTurn()),
                        robot.hasMotors(),
                        sonarOn,
                        sonars,
                        ranges(sonars),
                        (int) Math.round(Math.toDegrees(turn) * 10))
                .packet();
    }

    private int[] ranges(int[] sonars) {
        if (sonars.length == 0) {
            return sonars;
        }
        int[] all = robot.sonarRangesMillimeters();
        int[] ranges = new int[sonars.length];
        for (int i = 0; i < sonars.length; i++) {
            ranges[i] = all[sonars[i]];
        }
        return ranges;
    }

    byte[] encoders() {
        return P2osPacket.of(P2osPacket.data()
                .octet(ENCODER_ID)
                .fourOctets(P3dxScale.ticks(robot.odometry().leftMeters()))
                .fourOctets(P3dxScale.ticks(robot.odometry().rightMeters()))
                .toArray());
    }

    /** Two reserved bytes, flags, intervals, the true pose in mm and degrees, and no satellites. */
    byte[] simulator() {
        int step = (int) (Simulation.STEP_NANOS / 1_000_000);
        Pose pose = robot.pose();
        return P2osPacket.of(P2osPacket.data()
                .octet(SIMULATOR_ID)
                .twoOctets(0)
                .fourOctets(0)
                .twoOctets(step, step, step)
                .fourOctets(P3dxScale.millimeters(pose.xMeters()))
                .fourOctets(P3dxScale.millimeters(pose.yMeters()))
                .fourOctets(0)
                .fourOctets((int) Math.round(pose.headingDegrees()) % 360)
                .fourOctets(0)
                .fourOctets(0)
                .fourOctets(0)
                .octet(0)
                .toArray());
    }
}
