package simgsm.state;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * A state machine as data: the events accepted by a state, the next state, and the actions performed, in order. An
 * event without a row is refused. The table holds no current state; {@link StateMachine} does.
 *
 * <p>Rows are added once, while the table is built; afterwards any thread may read it.
 *
 * @param <S> states
 * @param <E> events
 * @param <A> actions
 */
public final class StateTable<S extends Enum<S>, E extends Enum<E>, A extends Enum<A>> {
    /** The action type of a table without actions. */
    public enum NoAction {}

    /** One row: in {@code state}, {@code event} leads to {@code next} and performs {@code actions}. */
    public record Row<S, E, A>(S state, E event, S next, List<A> actions) {}

    private final String name;
    private final S initial;
    private final List<Row<S, E, A>> rows = new ArrayList<>();
    private final Map<S, Map<E, Row<S, E, A>>> rowsByState;
    private Function<S, String> stateText = Enum::name;
    private Function<E, String> eventText = Enum::name;

    /**
     * An empty table.
     *
     * @param name titles the diagram and begins every log line, such as {@code "mobile call"}
     * @param initial state of a new machine
     */
    public StateTable(String name, S initial) {
        this.name = name;
        this.initial = initial;
        this.rowsByState = new EnumMap<>(initial.getDeclaringClass());
    }

    /**
     * Adds a row for each of the states.
     *
     * @throws IllegalArgumentException if one of them has a row for the event already
     */
    @SafeVarargs
    @SuppressWarnings("varargs")
    public final StateTable<S, E, A> on(Set<S> states, E event, S next, A... actions) {
        states.forEach(state -> add(new Row<>(state, event, next, List.of(actions))));
        return this;
    }

    /** Adds a row for each pair of a state and an event; otherwise as {@link #on(Set, Enum, Enum, Enum[])}. */
    @SafeVarargs
    @SuppressWarnings("varargs")
    public final StateTable<S, E, A> on(Set<S> states, Set<E> events, S next, A... actions) {
        events.forEach(event -> on(states, event, next, actions));
        return this;
    }

    /** Adds a row for one state; otherwise as {@link #on(Set, Enum, Enum, Enum[])}. */
    @SafeVarargs
    @SuppressWarnings("varargs")
    public final StateTable<S, E, A> on(S state, E event, S next, A... actions) {
        add(new Row<>(state, event, next, List.of(actions)));
        return this;
    }

    /**
     * Adds a row for each of the states that performs actions and keeps the state.
     *
     * @throws IllegalArgumentException if one of them has a row for the event already
     */
    @SafeVarargs
    @SuppressWarnings("varargs")
    public final StateTable<S, E, A> stay(Set<S> states, E event, A... actions) {
        states.forEach(state -> add(new Row<>(state, event, state, List.of(actions))));
        return this;
    }

    /** Replaces the enums' own names by these texts in the diagram. */
    public StateTable<S, E, A> texts(Function<S, String> ofState, Function<E, String> ofEvent) {
        stateText = ofState;
        eventText = ofEvent;
        return this;
    }

    private void add(Row<S, E, A> row) {
        Map<E, Row<S, E, A>> rowsByEvent =
                rowsByState.computeIfAbsent(row.state, state -> new EnumMap<>(row.event.getDeclaringClass()));
        if (rowsByEvent.putIfAbsent(row.event, row) != null) {
            throw new IllegalArgumentException(name + ": two rows for " + row.event + " in " + row.state);
        }
        rows.add(row);
    }

    public String name() {
        return name;
    }

    public S initial() {
        return initial;
    }

    /** The row for an event in a state; empty when the event is refused there. */
    public Optional<Row<S, E, A>> row(S state, E event) {
        return Optional.ofNullable(rowsByState.getOrDefault(state, Map.of()).get(event));
    }

    /** All rows, in the order in which they were added. */
    public Collection<Row<S, E, A>> rows() {
        return List.copyOf(rows);
    }

    /**
     * The table as a PlantUML state diagram. Events between the same two states share an arrow; rows that keep the state
     * are not drawn.
     */
    public String plantUml() {
        StringBuilder uml =
                new StringBuilder("@startuml\n!include look.iuml\ntitle %s\nhide empty description\n".formatted(name));
        for (S state : initial.getDeclaringClass().getEnumConstants()) {
            uml.append("state \"%s\" as %s\n".formatted(stateText.apply(state), state.name()));
        }
        uml.append("[*] --> %s\n".formatted(initial.name()));
        arrows().forEach((ends, events) -> uml.append("%s --> %s : %s\n"
                .formatted(
                        ends.get(0).name(),
                        ends.get(1).name(),
                        events.stream().map(eventText).collect(Collectors.joining("\\n")))));
        return uml.append("@enduml\n").toString();
    }

    private Map<List<S>, Set<E>> arrows() {
        Map<List<S>, Set<E>> arrows = new LinkedHashMap<>();
        for (Row<S, E, A> row : rows) {
            if (row.state != row.next) {
                arrows.computeIfAbsent(Arrays.asList(row.state, row.next), ends -> new LinkedHashSet<>())
                        .add(row.event);
            }
        }
        return arrows;
    }
}
