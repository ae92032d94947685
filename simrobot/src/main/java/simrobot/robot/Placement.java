package simrobot.robot;

/** The result of moving a robot by hand. */
public enum Placement {
    DONE("placed"),
    /** A wall, a box, a point or another robot occupies the place. */
    OCCUPIED("something is in the way there"),
    /** Outside the bounds of the world. */
    OUTSIDE("outside the world"),
    /** The robot is moving, so it cannot be moved by hand. */
    MOVING("the robot is moving");

    private final String text;

    Placement(String text) {
        this.text = text;
    }

    public String text() {
        return text;
    }
}
