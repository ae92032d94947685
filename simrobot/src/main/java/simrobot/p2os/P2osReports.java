package simrobot.p2os;

import java.util.List;
import simgsm.octets.OctetWriter;
import simrobot.robot.Bumpers;
import simrobot.robot.Odometry;
import simrobot.robot.Pioneer2Dx;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import vericommand.Pose;

/** The packets that a robot sends to its client about itself. */
final class P2osReports {
    private static final int INTRODUCTION_ID = 2;
    private static final int ENCODER_ID = 0x90;
    private static final int SIMULATOR_ID = 0x62;

    /** Player reads at most 19 octets. */
    private static final int NAME_LENGTH = 19;

    /** Value of unconnected digital inputs. */
    private static final int OPEN_INPUTS = 0xFF;

    private static final int NO_THERMOMETER = -127;

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

    /** @param sonars the sonars that fire; empty means all */
    void setPolled(List<Integer> sonars) {
        polled = sonars.isEmpty()
                ? P2osSession.allSonars()
                : sonars.stream().distinct().sorted().toList();
    }

    /** Returns the robot's name as sent to clients: at most 19 ASCII characters. */
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

    /** Returns the information packet, laid out as in {@link InformationPacket}. */
    byte[] information(long simulatedNanos) {
        Odometry odometry = robot.odometry();
        double speed = robot.speedMetersPerSecond();
        double turn = robot.turnRadiansPerSecond();
        double half = turn * Pioneer2Dx.EFFECTIVE_TRACK_METERS / 2;
        Bumpers bumpers = robot.bumpers();
        int stalled = stall.isNoticed(bumpers, simulatedNanos) ? 1 : 0;
        int batteryDecivolts = (int) Math.round(robot.battery().volts() * 10);
        OctetWriter data = P2osPacket.data()
                .octet(speed != 0 || turn != 0 ? InformationPacket.MOVING_ID : InformationPacket.STOPPED_ID)
                .twoOctets(P3dxScale.place(odometry.xMeters()), P3dxScale.place(odometry.yMeters()))
                .twoOctets(P3dxScale.angle(odometry.headingRadians()))
                .twoOctets(P3dxScale.millimeters(speed - half), P3dxScale.millimeters(speed + half))
                .octet(batteryDecivolts)
                .octet(bumpers.rear() << 1 | stalled)
                .octet(bumpers.front() << 1 | stalled)
                .twoOctets(P3dxScale.angle(
                        odometry.headingRadians() + robot.drive().remainingTurn()))
                .twoOctets((robot.hasMotors() ? InformationPacket.MOTORS_FLAG : 0)
                        | (sonarOn ? InformationPacket.SONAR_FLAGS : 0))
                .octet(0);
        writeSonars(data);
        data.octet(0).octet(0).octet(0).octet(OPEN_INPUTS).octet(0);
        data.twoOctets(batteryDecivolts).octet(0);
        data.twoOctets((int) Math.round(Math.toDegrees(turn) * 10), 0, 0).octet(NO_THERMOMETER);
        data.octet((int) Math.round(robot.battery().chargeShare() * 100));
        return P2osPacket.of(data.toArray());
    }

    private void writeSonars(OctetWriter data) {
        List<Integer> sonars = sonarOn ? polled : List.of();
        data.octet(sonars.size());
        if (!sonars.isEmpty()) {
            int[] ranges = robot.sonarRangesMillimeters();
            sonars.forEach(sonar -> data.octet(sonar).twoOctets(ranges[sonar]));
        }
    }

    byte[] encoders() {
        return P2osPacket.of(P2osPacket.data()
                .octet(ENCODER_ID)
                .fourOctets(P3dxScale.ticks(robot.odometry().leftMeters()))
                .fourOctets(P3dxScale.ticks(robot.odometry().rightMeters()))
                .toArray());
    }

    /**
     * Returns the simulator packet: two reserved bytes, flags, intervals, true pose in mm and degrees, no satellites.
     */
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
