package simrobot.robot;

/** What became of an attempt to put a robot somewhere by hand. */
public enum Placement {
    DONE("placed"),
    /** A wall, a box, a point or another robot is there. */
    OCCUPIED("something is in the way there"),
    /** Beyond all that the world holds; a robot would drive there for ever. */
    OUTSIDE("outside the world"),
    /** A moving robot stays on its way. */
    MOVING("the robot is moving");

    private final String text;

    Placement(String text) {
        this.text = text;
    }

    public String text() {
        return text;
    }
}
