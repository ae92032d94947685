package simrobot.editor;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import simrobot.world.ItemKind;
import simrobot.world.ItemKinds;
import simrobot.world.World;

/**
 * A world under edit: its current state, the undo and redo steps, and the selected item. During a drag the draft has a
 * preview; only its last state becomes a step.
 */
public final class Draft {
    /** Maximum of undo steps; worlds share their unchanged parts, so a step needs little memory. */
    private static final int MOST_UNDONE = 500;

    private final Deque<World> before = new ArrayDeque<>();
    private final Deque<World> after = new ArrayDeque<>();
    private World world;
    private World saved;
    private World preview;
    private Item selected;
    private World background;
    private World backgroundOf;
    private Item backgroundWithout;

    public Draft(World world) {
        this.world = world;
        saved = world;
    }

    /** The preview, or the world if there is none. */
    public World world() {
        return preview == null ? world : preview;
    }

    /** The world without the preview. */
    public World committed() {
        return world;
    }

    /** The item changed by the preview; empty without a preview. */
    public Optional<Item> moving() {
        if (preview == null || preview == world) {
            return Optional.empty();
        }
        for (ItemKind<?> kind : ItemKinds.ALL) {
            if (Edits.count(preview, kind) > Edits.count(world, kind)) {
                return Optional.of(Edits.last(preview, kind));
            }
        }
        return selected();
    }

    /**
     * The world without {@link #moving}; the same object while the same item moves, so that its picture can be cached.
     */
    public World background() {
        Item item = moving().filter(it -> Edits.has(world, it)).orElse(null);
        if (item == null) {
            return world;
        }
        if (backgroundOf != world || !item.equals(backgroundWithout)) {
            background = Edits.without(world, item);
            backgroundOf = world;
            backgroundWithout = item;
        }
        return background;
    }

    // ---- steps -----------------------------------------------------------------------------------------------------

    public void preview(World newPreview) {
        preview = newPreview;
    }

    /** Makes the preview a step; a preview that changes nothing is discarded. */
    public void commit() {
        if (preview != null) {
            change(preview);
        }
    }

    /** Drops the preview. */
    public void discard() {
        preview = null;
    }

    /** Adds an undo step; drops the preview. */
    public void change(World next) {
        preview = null;
        if (!next.equals(world)) {
            before.push(world);
            if (before.size() > MOST_UNDONE) {
                before.removeLast();
            }
            after.clear();
            world = next;
            select(selected);
        }
    }

    public boolean canUndo() {
        return !before.isEmpty();
    }

    public boolean canRedo() {
        return !after.isEmpty();
    }

    public void undo() {
        step(before, after);
    }

    public void redo() {
        step(after, before);
    }

    private void step(Deque<World> from, Deque<World> to) {
        preview = null;
        if (!from.isEmpty()) {
            to.push(world);
            world = from.pop();
            select(selected);
        }
    }

    /** True if it differs from the world that was last saved or loaded. */
    public boolean isChanged() {
        return world != saved && !world.equals(saved);
    }

    /** Marks this world as saved; the draft may have changed since the write. */
    public void markSaved(World written) {
        saved = written;
    }

    // ---- selection -------------------------------------------------------------------------------------------------

    public Optional<Item> selected() {
        return Optional.ofNullable(selected);
    }

    /** Selects an item; null or an unknown item clears the selection. */
    public void select(Item item) {
        selected = item == null || Edits.has(world(), item) ? item : null;
    }

    public void deleteSelected() {
        if (selected != null) {
            Item deleted = selected;
            selected = null;
            change(Edits.without(world, deleted));
        }
    }
}
