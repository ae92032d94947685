package simrobot.p2os;

import java.util.List;

/** A client's command; one record per command that the robot supports, units as on the wire. */
public sealed interface P2osCommand {
    /** Number 0: the first step of the handshake, later the keep-alive. */
    record Pulse() implements P2osCommand {}

    /** Number 1: the second step of the handshake, later the opening of the session. */
    record Open() implements P2osCommand {}

    /** Number 2: the last step of the handshake, later the session's end. */
    record Close() implements P2osCommand {}

    /**
     * Selects the sonars to fire.
     *
     * @param sonars 0 to 15, no others; empty means all
     */
    record Polling(List<Integer> sonars) implements P2osCommand {}

    record Enable(boolean motors) implements P2osCommand {}

    /** Acceleration in mm/s2; negative values set the deceleration. */
    record Acceleration(int millimetersPerSecond2) implements P2osCommand {}

    /** Angular acceleration in degrees/s2; negative values set the deceleration. */
    record TurnAcceleration(int degreesPerSecond2) implements P2osCommand {}

    record TopSpeed(int millimetersPerSecond) implements P2osCommand {}

    record TopTurnSpeed(int degreesPerSecond) implements P2osCommand {}

    /** Sets the odometry to 0, 0, 0. */
    record SetOrigin() implements P2osCommand {}

    record Move(int millimeters) implements P2osCommand {}

    record Rotate(int degreesPerSecond) implements P2osCommand {}

    record Velocity(int millimetersPerSecond) implements P2osCommand {}

    /** Each wheel's speed in units of 20 mm/s. */
    record WheelVelocities(int left, int right) implements P2osCommand {}

    /** Turns to an absolute heading of the odometry, through the smaller angle. */
    record Heading(int degrees) implements P2osCommand {}

    /** Turns relative to the current heading. */
    record TurnBy(int degrees) implements P2osCommand {}

    /** Turns relative to the heading that the robot is turning to. */
    record TurnByFromTarget(int degrees) implements P2osCommand {}

    record Configuration() implements P2osCommand {}

    /** Selects when encoder packets are sent: 0 never, 1 once, 2 with every information packet. */
    record Encoders(int mode) implements P2osCommand {}

    record Sonar(boolean on) implements P2osCommand {}

    record Stop() implements P2osCommand {}

    /** Stops at once, without deceleration. */
    record EmergencyStop() implements P2osCommand {}

    /** Selects the bumpers that stall the wheels at once: 0 none, 1 front, 2 rear, 3 both. */
    record BumpStall(boolean front, boolean rear) implements P2osCommand {}

    /** Sets the true pose, in mm and degrees; the odometry is unchanged. */
    record SimPose(int x, int y, int heading) implements P2osCommand {}

    /** Returns the robot to its first pose and sets the odometry to 0. */
    record SimReset() implements P2osCommand {}

    /** Selects when the simulator's status is sent, as for the encoders. */
    record SimStatus(int mode) implements P2osCommand {}

    /** A setting of the simulated laser. */
    enum LaserPart {
        /** 0 off, 1 plain packets, 2 extended ones. */
        MODE,
        /** Degrees, of the first reading. */
        START,
        /** Degrees, of the last reading. */
        END,
        /** Hundredths of a degree between readings. */
        STEP
    }

    record LaserCommand(LaserPart part, int value) implements P2osCommand {}

    /** Loads a world. */
    record SimLoad(String file) implements P2osCommand {}

    /** A text for the operator. */
    record SimMessage(String text) implements P2osCommand {}

    record BatteryTest(int decivolts) implements P2osCommand {}

    /** A command without effect: unknown, equipment not fitted, or its argument missing or of the wrong type. */
    record Unheeded(int number) implements P2osCommand {}
}
