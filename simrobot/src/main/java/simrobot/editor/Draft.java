package simrobot.editor;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Objects;
import java.util.Optional;
import simrobot.world.World;

/**
 * A world that is being edited: its present state, what came before and after, and what is selected. While the mouse drags,
 * the draft shows a try; only what it is at the end becomes one step that can be undone.
 */
public final class Draft {
    /** Worlds share what they have in common, so this costs little. */
    private static final int MOST_UNDONE = 500;

    private final Deque<World> before = new ArrayDeque<>();
    private final Deque<World> after = new ArrayDeque<>();
    private World world;
    private World saved;
    private World tried;
    private Item selected;
    private World still;
    private World stillOf;
    private Item stillWithout;

    public Draft(World world) {
        this.world = Objects.requireNonNull(world);
        saved = world;
    }

    /** As it is now, the present try included. */
    public World world() {
        return tried == null ? world : tried;
    }

    /** As it was before the present try. */
    public World settled() {
        return world;
    }

    /** The item that the present try makes or changes; none without a try. */
    public Optional<Item> moving() {
        if (tried == null || tried == world) {
            return Optional.empty();
        }
        for (Item.Kind kind : Item.Kind.values()) {
            if (Edits.count(tried, kind) > Edits.count(world, kind)) {
                return Optional.of(Edits.last(tried, kind));
            }
        }
        return selected();
    }

    /** All but what moves; the same object while the same item moves, so that it may be painted once. */
    public World still() {
        Item item = moving().filter(it -> Edits.has(world, it)).orElse(null);
        if (item == null) {
            return world;
        }
        if (stillOf != world || !item.equals(stillWithout)) {
            still = Edits.without(world, item);
            stillOf = world;
            stillWithout = item;
        }
        return still;
    }

    // ---- steps -----------------------------------------------------------------------------------------------------

    /** Shows what it would be like. */
    public void attempt(World attempt) {
        tried = attempt;
    }

    /** The present try becomes a step; a try that changes nothing does not. */
    public void settle() {
        World next = tried;
        tried = null;
        if (next != null) {
            change(next);
        }
    }

    /** The present try is forgotten. */
    public void forget() {
        tried = null;
    }

    /** One step that can be undone. */
    public void change(World next) {
        tried = null;
        if (!next.equals(world)) {
            before.push(world);
            if (before.size() > MOST_UNDONE) {
                before.removeLast();
            }
            after.clear();
            world = next;
            keepSelection();
        }
    }

    public boolean canUndo() {
        return !before.isEmpty();
    }

    public boolean canRedo() {
        return !after.isEmpty();
    }

    public void undo() {
        tried = null;
        if (canUndo()) {
            after.push(world);
            world = before.pop();
            keepSelection();
        }
    }

    public void redo() {
        tried = null;
        if (canRedo()) {
            before.push(world);
            world = after.pop();
            keepSelection();
        }
    }

    /** Whether it differs from what was saved or loaded last. */
    public boolean isChanged() {
        return world != saved && !world.equals(saved);
    }

    /** This very world is on the disk now; the draft may have gone on meanwhile. */
    public void saved(World written) {
        saved = written;
    }

    // ---- selection -------------------------------------------------------------------------------------------------

    public Optional<Item> selected() {
        return Optional.ofNullable(selected);
    }

    /** @param item null for none */
    public void select(Item item) {
        selected = item == null || Edits.has(world(), item) ? item : null;
    }

    public void deleteSelected() {
        if (selected != null) {
            Item gone = selected;
            selected = null;
            change(Edits.without(world, gone));
        }
    }

    private void keepSelection() {
        select(selected);
    }
}
