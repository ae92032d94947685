package simrobot.world;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** All kinds of items, in the order of {@code --print-world}. A new kind needs its class and a row here. */
public final class ItemKinds {
    public static final List<ItemKind<?>> ALL = List.of(
            Segment.KIND,
            Point.KIND,
            Home.KIND,
            Box.KIND,
            Goal.KIND,
            ForbiddenLine.KIND,
            ForbiddenArea.KIND,
            Treadmill.KIND);

    private ItemKinds() {}

    /** The kinds that the editor draws. */
    public static Stream<ItemKind<?>> edited() {
        return ALL.stream().filter(ItemKind::isEdited);
    }

    /** The kind of a cairn's type, ignoring case. */
    static Optional<ItemKind<?>> ofCairn(String cairnType) {
        String name = cairnType.toLowerCase(Locale.ROOT);
        return ALL.stream().filter(kind -> kind.isCairn(name)).findFirst();
    }
}
