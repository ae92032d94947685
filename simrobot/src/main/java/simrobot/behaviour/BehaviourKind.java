package simrobot.behaviour;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Collectors;

/** The processes that a robot may run. */
public enum BehaviourKind {
    /** Stands until somebody steers it. */
    NONE("none"),
    /** Goes ahead, and turns away from what is near. */
    WANDER("wander"),
    /** Keeps a wall to its right. */
    WALL_FOLLOW("wall-follow");

    private final String text;

    BehaviourKind(String text) {
        this.text = text;
    }

    /** The word that command lines, consoles and windows use. */
    public String text() {
        return text;
    }

    /** A new process of this kind; empty for {@link #NONE}. @param robotNumber of robots in their order, the first is 0 */
    public Optional<Behaviour> begin(int robotNumber) {
        return switch (this) {
            case NONE -> Optional.empty();
            case WANDER -> Optional.of(new Wander(robotNumber));
            case WALL_FOLLOW -> Optional.of(new WallFollow());
        };
    }

    /** @throws IllegalArgumentException saying which words there are */
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
