package simrobot.world;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/**
 * A kind of item, declared once in the class of its items for the map reader and writer, {@code --print-world}, the
 * editor's tools and form, and the tests.
 */
public final class ItemKind<T extends WorldItem> {
    /** Shape drawn by the editor between two positions: at the first one, as a line, or as a rectangle. */
    public enum Shape {
        PLACE,
        LINE,
        AREA
    }

    /** Reads the item from a cairn of a map file. */
    interface CairnReader<T> {
        T read(Cairn cairn) throws WorldFormatException;
    }

    /** Creates an item between two positions. */
    public interface Drawn<T> {
        T between(World world, Position from, Position to);
    }

    private final String word;
    private final Class<T> type;
    private final List<ItemField<T>> fields = new ArrayList<>();
    private String printedAs;
    private Set<String> cairns = Set.of();
    private CairnReader<T> reader;
    private Function<T, Cairn> writer;
    private Shape shape = Shape.PLACE;
    private Function<Map<String, Object>, T> maker;
    private Drawn<T> drawn;

    ItemKind(String word, Class<T> type) {
        this.word = word;
        this.type = type;
        printedAs = word;
    }

    // ---- declaration, for the items' classes -----------------------------------------------------------------------

    /** @param newWord the first word of its rows of {@code --print-world}, if it differs from the kind's */
    ItemKind<T> printedAs(String newWord) {
        printedAs = newWord;
        return this;
    }

    ItemKind<T> text(String key, Function<T, Object> value) {
        return field(key, ItemField.Unit.TEXT, value, true);
    }

    ItemKind<T> number(String key, ItemField.Unit unit, Function<T, Object> value) {
        return field(key, unit, value, true);
    }

    ItemKind<T> field(String key, ItemField.Unit unit, Function<T, Object> value, boolean isTyped) {
        fields.add(new ItemField<>(key, unit, value, isTyped));
        return this;
    }

    /** The two ends of a line, or the corners of an area before its rotation. */
    ItemKind<T> corners(Function<T, double[]> corners) {
        List<String> keys = List.of("x1", "y1", "x2", "y2");
        for (int i = 0; i < keys.size(); i++) {
            int at = i;
            number(keys.get(i), ItemField.Unit.METERS, item -> corners.apply(item)[at]);
        }
        return this;
    }

    /** @param names the cairn's types in lower case */
    ItemKind<T> cairn(Set<String> names, CairnReader<T> newReader, Function<T, Cairn> newWriter) {
        cairns = names;
        reader = newReader;
        writer = newWriter;
        return this;
    }

    /**
     * Makes the kind drawable and editable.
     *
     * @param newMaker from the fields' values by their keys
     */
    ItemKind<T> edited(Shape newShape, Function<Map<String, Object>, T> newMaker, Drawn<T> newDrawn) {
        shape = newShape;
        maker = newMaker;
        drawn = newDrawn;
        return this;
    }

    /** The rectangle of a form's values. */
    static Area area(Map<String, Object> values) {
        return Area.between(
                (Double) values.get("x1"),
                (Double) values.get("y1"),
                (Double) values.get("x2"),
                (Double) values.get("y2"),
                (Double) values.getOrDefault("rotation", 0.0));
    }

    // ---- use -------------------------------------------------------------------------------------------------------

    /** The kind's English word, the last part of the keys of its texts. */
    public String word() {
        return word;
    }

    public Class<T> type() {
        return type;
    }

    /** Its row of {@code --print-world}: numbers in millimetres and degrees, then texts. */
    public List<String> printed(WorldItem item) {
        T own = type.cast(item);
        List<String> row = new ArrayList<>(List.of(printedAs));
        for (boolean isText : new boolean[] {false, true}) {
            fields.stream()
                    .filter(field -> isText == (field.unit() == ItemField.Unit.TEXT))
                    .forEach(field -> row.add(field.printed(own)));
        }
        return row;
    }

    /** True if the type of a cairn, in lower case, is one of this kind's. */
    boolean isCairn(String name) {
        return cairns.contains(name);
    }

    WorldItem read(Cairn cairn) throws WorldFormatException {
        return reader.read(cairn);
    }

    /** The item as a cairn; empty for walls and points, which have sections in the file. */
    Optional<Cairn> cairn(WorldItem item) {
        return Optional.ofNullable(writer).map(writing -> writing.apply(type.cast(item)));
    }

    /** True if the editor draws and changes items of this kind. */
    public boolean isEdited() {
        return drawn != null;
    }

    public Shape shape() {
        return shape;
    }

    public WorldItem drawn(World world, Position from, Position to) {
        return drawn.between(world, from, to);
    }

    /** The item's fields by their keys, as in the form. */
    public Map<String, String> form(WorldItem item) {
        Map<String, String> form = new LinkedHashMap<>();
        fields.stream()
                .filter(ItemField::isTyped)
                .forEach(field -> form.put(field.key(), field.typed(type.cast(item))));
        return form;
    }

    public List<ItemField<T>> fields() {
        return List.copyOf(fields);
    }

    /**
     * The item with other values.
     *
     * @param values of the changed fields, by their keys, SI
     */
    public WorldItem changed(WorldItem item, Map<String, Object> values) {
        Map<String, Object> all = new LinkedHashMap<>();
        fields.forEach(field -> all.put(field.key(), field.value().apply(type.cast(item))));
        all.putAll(values);
        return maker.apply(all);
    }
}
