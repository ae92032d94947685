package simrobot.editor;

import java.util.HashMap;
import java.util.Map;
import simrobot.world.ItemField;
import simrobot.world.World;
import simrobot.world.WorldItem;

/** An item as text fields: metres, degrees, metres per second. */
public final class ItemFields {
    private ItemFields() {}

    /** An unreadable text of a field; the message is the text. */
    public static final class FieldRefusal extends Exception {
        private final String field;

        FieldRefusal(String field, String found) {
            super(found);
            this.field = field;
        }

        /** The field's key. */
        public String field() {
            return field;
        }
    }

    /** The item's fields by their keys, in the order of the form. */
    public static Map<String, String> of(World world, Item reference) {
        return reference.kind().form(Edits.get(world, reference));
    }

    /** The world with the item's new field values; the same world if no field differs. */
    public static World changed(World world, Item reference, Map<String, String> typed) throws FieldRefusal {
        if (typed.equals(of(world, reference))) {
            return world;
        }
        Map<String, Object> values = new HashMap<>();
        for (ItemField<?> field : reference.kind().fields()) {
            if (field.isTyped()) {
                values.put(field.key(), value(field, typed.get(field.key()).strip()));
            }
        }
        WorldItem item = Edits.get(world, reference);
        return Edits.replaced(world, reference, reference.kind().changed(item, values));
    }

    /** Parses a field; numbers are decimals with a dot or a comma. */
    private static Object value(ItemField<?> field, String typed) throws FieldRefusal {
        if (field.unit() == ItemField.Unit.TEXT) {
            return typed;
        }
        String word = typed.replace(',', '.');
        if (word.matches("[-+]?([0-9]{1,9}(\\.[0-9]*)?|\\.[0-9]+)")) {
            double number = Double.parseDouble(word);
            if (Math.abs(number) <= field.unit().most()) {
                return field.fromTyped(number);
            }
        }
        throw new FieldRefusal(field.key(), typed);
    }
}
