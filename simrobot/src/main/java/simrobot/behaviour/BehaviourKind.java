package simrobot.behaviour;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;

/** The autonomous processes that a robot can run. */
public enum BehaviourKind {
    /** No process: the robot moves on commands only. */
    NONE("none"),
    /** Drives ahead and turns away from near obstacles. */
    WANDER("wander"),
    /** Keeps a wall to its right. */
    WALL_FOLLOW("wall-follow");

    private final String text;

    BehaviourKind(String text) {
        this.text = text;
    }

    /** Returns the name used in command lines, consoles and windows. */
    public String text() {
        return text;
    }

    /** Creates a process of this kind; empty for {@link #NONE}. @param robotNumber index of the robot, from 0 */
    public Optional<Behaviour> begin(int robotNumber) {
        return switch (this) {
            case NONE -> Optional.empty();
            case WANDER -> Optional.of(new Wander(robotNumber));
            case WALL_FOLLOW -> Optional.of(new WallFollow());
        };
    }

    /** @throws IllegalArgumentException if the name is unknown; the message lists the known ones */
    public static BehaviourKind ofText(String text) {
        return Arrays.stream(values())
                .filter(kind -> kind.text.equals(text))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("expected " + words() + ", found " + text));
    }

    private static String words() {
        return Arrays.stream(values()).map(BehaviourKind::text).collect(Collectors.joining(", "));
    }
}
