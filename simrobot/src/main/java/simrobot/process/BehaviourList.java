package simrobot.process;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The available processes in the order of their numbers: wander, wall-follow, those of students by name, then those of
 * the world's goals. Methods may be called on any thread.
 */
public final class BehaviourList {
    /** The largest number, because orders name a process by one digit. */
    public static final int MAX_NUMBER = 9;

    /**
     * The reason why a file makes no process, or a process ended.
     *
     * @param line of the source; 0 if unknown
     */
    public record Fault(String name, int line, String text) {}

    private final SortedMap<String, Fault> faults = new TreeMap<>();
    private final SortedMap<String, BehaviourKind> students = new TreeMap<>();
    private List<BehaviourKind> goals = List.of();
    private Function<String, Optional<BehaviourKind>> places = name -> Optional.empty();

    /** A list of the built-in kinds. */
    public BehaviourList() {}

    /** Returns all kinds that run something, in the order of their numbers, from 1. */
    public synchronized List<BehaviourKind> kinds() {
        List<BehaviourKind> kinds = new ArrayList<>(BehaviourKind.BUILT_IN);
        kinds.remove(BehaviourKind.NONE);
        kinds.addAll(students.values());
        kinds.addAll(goals);
        return List.copyOf(kinds);
    }

    /** Returns {@link #kinds} with {@link BehaviourKind#NONE} in front. */
    public List<BehaviourKind> withNone() {
        return Stream.concat(Stream.of(BehaviourKind.NONE), kinds().stream()).toList();
    }

    /** Adds a student's process, or replaces the one of the same name. */
    public synchronized void put(BehaviourKind kind) {
        students.put(kind.text(), kind);
        faults.remove(kind.text());
    }

    /** Removes a student's process. */
    public synchronized void remove(String name) {
        students.remove(name);
    }

    /** Returns the newest fault of each process or file that has one. */
    public synchronized List<Fault> faults() {
        return List.copyOf(faults.values());
    }

    public synchronized void setFault(Fault fault) {
        faults.put(fault.name(), fault);
    }

    public synchronized void clearFault(String name) {
        faults.remove(name);
    }

    /** Replaces the processes of the world's goals. */
    public synchronized void setGoals(List<BehaviourKind> kinds) {
        goals = List.copyOf(kinds);
    }

    /** Sets where to find the process that drives to a place of the world. */
    public synchronized void setPlaces(Function<String, Optional<BehaviourKind>> find) {
        places = find;
    }

    /**
     * Returns the process that drives to a place.
     *
     * @throws IllegalArgumentException if the world has no place of this name
     */
    public synchronized BehaviourKind toPlace(String name) {
        return places.apply(name)
                .orElseThrow(() -> new IllegalArgumentException("expected a goal or home of the world, found " + name));
    }

    /**
     * Returns the process of this name, {@link BehaviourKind#NONE} included.
     *
     * @throws IllegalArgumentException if there is none; the message lists the names
     */
    public BehaviourKind of(String name) {
        List<BehaviourKind> kinds = withNone();
        return BehaviourKind.find(kinds, name).orElseThrow(() -> BehaviourKind.unknown(kinds, name));
    }
}
