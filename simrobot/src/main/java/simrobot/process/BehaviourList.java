package simrobot.process;

import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * The available processes in the order of their numbers: wander 1, wall-follow 2, those of students, then those
 * of the world's goals. A student's process keeps its number while the list exists, also when it is removed and comes back.
 * Methods may be called on any thread.
 */
public final class BehaviourList {
    /** The largest number, because orders name a process by one or two digits. */
    public static final int MAX_NUMBER = 99;

    /** The number of the first student's process: those before it are built in. */
    public static final int FIRST_OWN_NUMBER = BehaviourKind.BUILT_IN.size();

    /**
     * The reason why a file makes no process, or a process ended.
     *
     * @param line of the source; 0 if unknown
     */
    public record Fault(String name, int line, String text) {}

    private final SortedMap<String, Fault> faults = new TreeMap<>();
    private final SortedMap<String, BehaviourKind> students = new TreeMap<>();
    /** By name: the numbers of students' processes, also of those that are not there now. */
    private final Map<String, Integer> numbers = new HashMap<>();

    private List<BehaviourKind> goals = List.of();
    private Function<String, Optional<BehaviourKind>> places = name -> Optional.empty();

    /** A list of the built-in kinds. */
    public BehaviourList() {}

    /** Returns all kinds that run something, in the order of their numbers, from 1; those without one are the last. */
    public synchronized List<BehaviourKind> kinds() {
        Set<BehaviourKind> kinds = new LinkedHashSet<>(numbered().values());
        kinds.addAll(students.values());
        kinds.addAll(goals);
        return List.copyOf(kinds);
    }

    /** Returns the kinds that orders can start, by number. */
    public synchronized SortedMap<Integer, BehaviourKind> numbered() {
        SortedMap<Integer, BehaviourKind> kinds = new TreeMap<>();
        for (int number = 1; number < FIRST_OWN_NUMBER; number++) {
            kinds.put(number, BehaviourKind.BUILT_IN.get(number));
        }
        for (BehaviourKind kind : students.values()) {
            if (numbers.containsKey(kind.text())) {
                kinds.put(numbers.get(kind.text()), kind);
            }
        }
        int number = numbers.isEmpty() ? FIRST_OWN_NUMBER : Collections.max(numbers.values()) + 1;
        for (BehaviourKind goal : goals) {
            if (number <= MAX_NUMBER) {
                kinds.put(number++, goal);
            }
        }
        return kinds;
    }

    /** Replaces the numbers of students' processes: by name, from {@link #FIRST_OWN_NUMBER}, each once. */
    public synchronized void setNumbers(Map<String, Integer> given) {
        numbers.clear();
        numbers.putAll(given);
        students.keySet().forEach(this::number);
    }

    private void number(String name) {
        if (!numbers.containsKey(name)) {
            freeNumber(numbers.values()).ifPresent(number -> numbers.put(name, number));
        }
    }

    /** The least number that none of these is, for a student's process; empty if there is none. */
    public static OptionalInt freeNumber(Collection<Integer> taken) {
        return IntStream.rangeClosed(FIRST_OWN_NUMBER, MAX_NUMBER)
                .filter(number -> !taken.contains(number))
                .findFirst();
    }

    /** Returns {@link #kinds} with {@link BehaviourKind#NONE} in front. */
    public List<BehaviourKind> withNone() {
        return Stream.concat(Stream.of(BehaviourKind.NONE), kinds().stream()).toList();
    }

    /** Adds a student's process, or replaces the one of the same name. One without a number gets the least that is free. */
    public synchronized void put(BehaviourKind kind) {
        number(kind.text());
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
