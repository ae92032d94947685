package simgsm.state;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A state machine as data: which events a state accepts, where each leads and what is done on the way. An event without a
 * row is refused by whoever asks.
 */
public final class StateTable<S extends Enum<S>, E extends Enum<E>, A extends Enum<A>> {
    public record Row<S, A>(S next, List<A> actions) {}

    private record Key<S, E>(S state, E event) {}

    private final Map<Key<S, E>, Row<S, A>> rows = new HashMap<>();

    /** Adds a row for each of the states. */
    @SafeVarargs
    @SuppressWarnings("varargs")
    public final StateTable<S, E, A> on(Set<S> states, E event, S next, A... actions) {
        states.forEach(state -> add(state, event, new Row<>(next, List.of(actions))));
        return this;
    }

    /** Adds a row for each of the states that leaves it where it is. */
    @SafeVarargs
    @SuppressWarnings("varargs")
    public final StateTable<S, E, A> stay(Set<S> states, E event, A... actions) {
        states.forEach(state -> add(state, event, new Row<>(state, List.of(actions))));
        return this;
    }

    private void add(S state, E event, Row<S, A> row) {
        if (rows.put(new Key<>(state, event), row) != null) {
            throw new IllegalArgumentException("two rows for " + state + " and " + event);
        }
    }

    public Optional<Row<S, A>> row(S state, E event) {
        return Optional.ofNullable(rows.get(new Key<>(state, event)));
    }
}
