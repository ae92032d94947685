package simrobot.editor;

import simrobot.world.ItemKind;

/**
 * A reference to an item of a world.
 *
 * @param index in the world's list of the kind
 */
public record Item(ItemKind<?> kind, int index) {
    public Item {
        if (index < 0) {
            throw new IllegalArgumentException("item " + index + ", expected 0 or more");
        }
    }
}
