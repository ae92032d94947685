package simrobot.p2os;

import java.util.List;

/** What a client can tell the robot; one record for each thing that the robot knows to do, units as on the wire. */
public sealed interface P2osCommand {
    /** Number 0: the first step of the handshake, later a sign of life. */
    record Pulse() implements P2osCommand {}

    /** Number 1: the second step of the handshake, later the opening of the session. */
    record Open() implements P2osCommand {}

    /** Number 2: the last step of the handshake, later the session's end. */
    record Close() implements P2osCommand {}

    /**
     * The sonars that are to be fired.
     *
     * @param sonars 0 to 15, no others; empty means all
     */
    record Polling(List<Integer> sonars) implements P2osCommand {}

    record Enable(boolean motors) implements P2osCommand {}

    /** mm/s2; below 0 the deceleration. */
    record Acceleration(int millimetersPerSecond2) implements P2osCommand {}

    /** Degrees/s2; below 0 the deceleration. */
    record TurnAcceleration(int degreesPerSecond2) implements P2osCommand {}

    record TopSpeed(int millimetersPerSecond) implements P2osCommand {}

    record TopTurnSpeed(int degreesPerSecond) implements P2osCommand {}

    /** The odometry becomes 0, 0, 0. */
    record SetOrigin() implements P2osCommand {}

    record Move(int millimeters) implements P2osCommand {}

    record Rotate(int degreesPerSecond) implements P2osCommand {}

    record Velocity(int millimetersPerSecond) implements P2osCommand {}

    /** Each wheel's speed in units of 20 mm/s. */
    record WheelVelocities(int left, int right) implements P2osCommand {}

    /** To an absolute heading of the odometry, the short way round. */
    record Heading(int degrees) implements P2osCommand {}

    /** From the heading that the robot has. */
    record TurnBy(int degrees) implements P2osCommand {}

    /** From the heading that the robot is turning to. */
    record TurnByFromTarget(int degrees) implements P2osCommand {}

    record Configuration() implements P2osCommand {}

    /** How often the encoders are told: 0 no more, 1 once, 2 with every information packet. */
    record Encoders(int mode) implements P2osCommand {}

    record Sonar(boolean on) implements P2osCommand {}

    record Stop() implements P2osCommand {}

    /** Without deceleration. */
    record EmergencyStop() implements P2osCommand {}

    /** Which bumpers make the wheels stall at once: 0 none, 1 front, 2 rear, 3 both. */
    record BumpStall(boolean front, boolean rear) implements P2osCommand {}

    /** The true pose, the odometry stays; mm and degrees. */
    record SimPose(int x, int y, int heading) implements P2osCommand {}

    /** Back to where the robot began, with the odometry at zero. */
    record SimReset() implements P2osCommand {}

    /** How often the simulator's own status is told, as for the encoders. */
    record SimStatus(int mode) implements P2osCommand {}

    record Battery(int decivolts) implements P2osCommand {}

    /** Nothing that this robot does: not known, not fitted, or its argument is missing or of the wrong kind. */
    record Unheeded(int number) implements P2osCommand {}
}
