package simgsm.state;

import java.lang.System.Logger.Level;
import java.util.function.Consumer;

/**
 * One machine that runs by a {@link StateTable}: holds the current state, performs the actions of a row after the state has
 * changed, and logs each transition at level TRACE with the machine's owner. Owned by one thread.
 */
public final class StateMachine<S extends Enum<S>, E extends Enum<E>, A extends Enum<A>> {
    private static final System.Logger LOG = System.getLogger(StateMachine.class.getName());

    private final StateTable<S, E, A> table;
    private final Object owner;
    private final Consumer<A> performer;
    private Consumer<S> entered = before -> {};
    private S state;

    /** A machine in the table's initial state; otherwise as the other constructor. */
    public StateMachine(StateTable<S, E, A> table, Object owner, Consumer<A> performer) {
        this(table, owner, performer, table.initial());
    }

    /**
     * A machine in a given state, for restoring a recorded one.
     *
     * @param owner named in the log by its {@code toString}
     * @param performer performs one action; may fire further events
     */
    public StateMachine(StateTable<S, E, A> table, Object owner, Consumer<A> performer, S state) {
        this.table = table;
        this.owner = owner;
        this.performer = performer;
        this.state = state;
    }

    /** Sets a hook that receives the previous state after each change of state, before the actions of the row. */
    public StateMachine<S, E, A> onEntry(Consumer<S> hook) {
        entered = hook;
        return this;
    }

    public S state() {
        return state;
    }

    public boolean accepts(E event) {
        return table.row(state, event).isPresent();
    }

    /**
     * Makes the transition of the row for {@code event}, then performs its actions in order.
     *
     * @return false, with state and world unchanged, when the current state has no row for the event
     */
    public boolean fire(E event) {
        S before = state;
        var row = table.row(before, event);
        if (row.isEmpty()) {
            LOG.log(Level.TRACE, () -> "%s of %s: %s refused in %s".formatted(table.name(), owner, event, before));
            return false;
        }
        state = row.get().next();
        LOG.log(
                Level.TRACE,
                () -> "%s of %s: %s -> %s by %s"
                        .formatted(table.name(), owner, before, row.get().next(), event));
        if (state != before) {
            entered.accept(before);
        }
        row.get().actions().forEach(performer);
        return true;
    }
}
