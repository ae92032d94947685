package simrobot.process;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** A process that robots can run. Kinds of the same name are equal. */
public final class BehaviourKind {
    /** Starts a process of one kind for one robot. */
    @FunctionalInterface
    public interface Start {
        RobotProcess in(Surroundings surroundings);
    }

    /** No process: the robot moves on commands only. */
    public static final BehaviourKind NONE = new BehaviourKind("none", null);

    /** Drives ahead and turns away from near obstacles. */
    public static final BehaviourKind WANDER =
            new BehaviourKind("wander", around -> RobotProcess.inPlace(new Wander(around.robotNumber())));

    /** Keeps a wall to its right. */
    public static final BehaviourKind WALL_FOLLOW =
            new BehaviourKind("wall-follow", around -> RobotProcess.inPlace(new WallFollow()));

    /** The kinds that every SimRobot has, {@link #NONE} first. */
    public static final List<BehaviourKind> BUILT_IN = List.of(NONE, WANDER, WALL_FOLLOW);

    private final String text;
    private final Start start;

    /** @param start null for a kind that is only shown */
    public BehaviourKind(String text, Start start) {
        this.text = text;
        this.start = start;
    }

    /** Returns the name used in command lines, consoles and windows. */
    public String text() {
        return text;
    }

    /** Creates a process of this kind; empty for {@link #NONE} and for kinds that are only shown. */
    public Optional<RobotProcess> begin(Surroundings surroundings) {
        return Optional.ofNullable(start).map(kind -> kind.in(surroundings));
    }

    /** Returns the built-in kind of this name, else one that is only shown, as in a recording. */
    public static BehaviourKind shown(String text) {
        return find(BUILT_IN, text).orElseGet(() -> new BehaviourKind(text, null));
    }

    /** @throws IllegalArgumentException if no built-in kind has this name; the message lists them */
    public static BehaviourKind ofText(String text) {
        return find(BUILT_IN, text).orElseThrow(() -> unknown(BUILT_IN, text));
    }

    /** Returns the kind of this name; else the only one whose name differs in case alone. */
    static Optional<BehaviourKind> find(List<BehaviourKind> kinds, String text) {
        Optional<BehaviourKind> same =
                kinds.stream().filter(kind -> kind.text.equals(text)).findFirst();
        return same.or(() -> {
            List<BehaviourKind> alike = kinds.stream()
                    .filter(kind -> kind.text.equalsIgnoreCase(text))
                    .toList();
            return alike.size() == 1 ? Optional.of(alike.get(0)) : Optional.empty();
        });
    }

    static IllegalArgumentException unknown(List<BehaviourKind> kinds, String text) {
        String words = kinds.stream().map(BehaviourKind::text).collect(Collectors.joining(", "));
        return new IllegalArgumentException("expected " + words + ", found " + text);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof BehaviourKind kind && kind.text.equals(text);
    }

    @Override
    public int hashCode() {
        return text.hashCode();
    }

    @Override
    public String toString() {
        return text;
    }
}
