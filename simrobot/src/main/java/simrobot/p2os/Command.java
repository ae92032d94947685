package simrobot.p2os;

import java.util.List;

/** What a client can tell the robot; one record for each thing that the robot knows to do, units as on the wire. */
public sealed interface Command {
    /** Number 0: the first step of the handshake, later a sign of life. */
    record Pulse() implements Command {}

    /** Number 1: the second step of the handshake, later the opening of the session. */
    record Open() implements Command {}

    /** Number 2: the last step of the handshake, later the session's end. */
    record Close() implements Command {}

    /**
     * The sonars that are to be fired.
     *
     * @param sonars 0 to 15, no others; empty means all
     */
    record Polling(List<Integer> sonars) implements Command {}

    record Enable(boolean motors) implements Command {}

    /** mm/s2; below 0 the deceleration. */
    record Acceleration(int millimetersPerSecond2) implements Command {}

    /** Degrees/s2; below 0 the deceleration. */
    record TurnAcceleration(int degreesPerSecond2) implements Command {}

    record TopSpeed(int millimetersPerSecond) implements Command {}

    record TopTurnSpeed(int degreesPerSecond) implements Command {}

    /** The odometry becomes 0, 0, 0. */
    record SetOrigin() implements Command {}

    record Move(int millimeters) implements Command {}

    record Rotate(int degreesPerSecond) implements Command {}

    record Velocity(int millimetersPerSecond) implements Command {}

    /** Each wheel's speed in units of 20 mm/s. */
    record WheelVelocities(int left, int right) implements Command {}

    /** To an absolute heading of the odometry, the short way round. */
    record Heading(int degrees) implements Command {}

    /** From the heading that the robot has. */
    record TurnBy(int degrees) implements Command {}

    /** From the heading that the robot is turning to. */
    record TurnByFromTarget(int degrees) implements Command {}

    record Configuration() implements Command {}

    /** How often the encoders are told: 0 no more, 1 once, 2 with every information packet. */
    record Encoders(int mode) implements Command {}

    record Sonar(boolean on) implements Command {}

    record Stop() implements Command {}

    /** Without deceleration. */
    record EmergencyStop() implements Command {}

    /** Which bumpers make the wheels stall at once: 0 none, 1 front, 2 rear, 3 both. */
    record BumpStall(boolean front, boolean rear) implements Command {}

    /** The true pose, the odometry stays; mm and degrees. */
    record SimPose(int x, int y, int heading) implements Command {}

    /** Back to where the robot began, with the odometry at zero. */
    record SimReset() implements Command {}

    /** How often the simulator's own status is told, as for the encoders. */
    record SimStatus(int mode) implements Command {}

    record Battery(int decivolts) implements Command {}

    /** Nothing that this robot does: not known, not fitted, or its argument is missing or of the wrong kind. */
    record Unheeded(int number) implements Command {}
}
