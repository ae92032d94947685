package simrobot.ui.editor;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import simgsm.console.TextBundle;
import simrobot.drawing.NumberTexts;
import simrobot.editor.Edits;
import simrobot.editor.Item;
import simrobot.world.ItemField;
import simrobot.world.ItemKind;
import simrobot.world.ItemKinds;
import simrobot.world.Position;
import simrobot.world.World;
import simrobot.world.WorldItem;

/** Lists items and describes them in words. */
final class EditorItems {
    private EditorItems() {}

    /** All items; walls last, because most items are walls. */
    static List<Item> all(World world) {
        List<Item> items = new ArrayList<>();
        Stream<ItemKind<?>> kinds =
                ItemKinds.edited().sorted(Comparator.comparing(kind -> kind.shape() == ItemKind.Shape.LINE));
        kinds.forEach(kind -> {
            for (int i = 0; i < Edits.count(world, kind); i++) {
                items.add(new Item(kind, i));
            }
        });
        return items;
    }

    /** The text of its kind: argument 0 is the middle of the item, its fields follow. */
    static String text(TextBundle texts, WorldItem item) {
        List<Object> arguments = new ArrayList<>(List.of(middle(item.outline())));
        arguments.addAll(shown(item.kind(), item));
        return texts.of("editor.item." + item.kind().word(), arguments.toArray());
    }

    private static <T extends WorldItem> List<String> shown(ItemKind<T> kind, WorldItem item) {
        T own = kind.type().cast(item);
        return kind.fields().stream()
                .map(field -> field.unit() == ItemField.Unit.TEXT
                        ? (String) field.value().apply(own)
                        : NumberTexts.fixed(field.number(own), 2))
                .toList();
    }

    private static String middle(List<Position> outline) {
        double x = outline.stream().mapToDouble(Position::xMeters).average().orElseThrow();
        double y = outline.stream().mapToDouble(Position::yMeters).average().orElseThrow();
        return NumberTexts.fixed(x, 2) + " " + NumberTexts.fixed(y, 2);
    }
}
