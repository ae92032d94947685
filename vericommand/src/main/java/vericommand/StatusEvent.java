package vericommand;

/** Events that can change a robot's status. */
public enum StatusEvent {
    POWER_ON("power on"),
    POWER_OFF("power off"),
    MOTORS_ON("motors on"),
    MOTORS_OFF("motors off"),
    /** An instruction (or an autonomous process) sets the robot in motion. */
    MOTION_STARTED("motion starts"),
    /**
     * The robot has stopped: after a forward motion that touched nothing, or after a turn with the way ahead free.
     */
    MOTION_ENDED("motion ends"),
    /** The robot touches something while it moves. */
    TOUCHED("touches something"),
    /** A turn made in Collision has ended and the way ahead is free for less than 1 cm. */
    TURN_ENDED_BLOCKED("turn ends, way blocked");

    private final String text;

    StatusEvent(String text) {
        this.text = text;
    }

    public String text() {
        return text;
    }
}
