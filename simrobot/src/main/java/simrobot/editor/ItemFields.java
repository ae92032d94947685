package simrobot.editor;

import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.World;
import simrobot.world.WorldItem;

/** An item as text fields: metres, degrees, metres per second. */
public final class ItemFields {
    /** Within the range of a map file. */
    private static final double MOST_METERS = 100_000;

    private static final double MOST_BELT_METERS_PER_SECOND = 10;

    private ItemFields() {}

    /** A field whose text cannot be read; the message is the text. */
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
        WorldItem item = Edits.get(world, reference);
        Map<String, String> fields = new LinkedHashMap<>();
        if (item instanceof Segment w) {
            corners(fields, w.x1Meters(), w.y1Meters(), w.x2Meters(), w.y2Meters());
        } else if (item instanceof Box box) {
            fields.put("name", box.name());
            corners(fields, box.area());
        } else if (item instanceof Home home) {
            fields.put("name", home.name());
            fields.put("x", text(home.position().xMeters()));
            fields.put("y", text(home.position().yMeters()));
            fields.put("heading", degrees(home.headingRadians()));
        } else if (item instanceof Treadmill belt) {
            fields.put("speed", text(belt.speedMetersPerSecond()));
            fields.put("direction", degrees(belt.directionRadians()));
            corners(fields, belt.area());
        }
        return fields;
    }

    private static void corners(Map<String, String> fields, Area area) {
        corners(fields, area.minXMeters(), area.minYMeters(), area.maxXMeters(), area.maxYMeters());
    }

    private static void corners(Map<String, String> fields, double x1, double y1, double x2, double y2) {
        fields.put("x1", text(x1));
        fields.put("y1", text(y1));
        fields.put("x2", text(x2));
        fields.put("y2", text(y2));
    }

    /** The world with the item as the fields say; the same world when no field differs. */
    public static World changed(World world, Item reference, Map<String, String> fields) throws FieldRefusal {
        return fields.equals(of(world, reference))
                ? world
                : Edits.replaced(world, reference, changed(Edits.get(world, reference), fields));
    }

    private static WorldItem changed(WorldItem item, Map<String, String> fields) throws FieldRefusal {
        if (item instanceof Segment) {
            return Segment.between(
                    new Position(meters(fields, "x1"), meters(fields, "y1")),
                    new Position(meters(fields, "x2"), meters(fields, "y2")));
        }
        if (item instanceof Box box) {
            return new Box(fields.get("name").strip(), area(fields, box.area()));
        }
        if (item instanceof Treadmill belt) {
            return new Treadmill(
                    area(fields, belt.area()),
                    number(fields, "speed", MOST_BELT_METERS_PER_SECOND),
                    Math.toRadians(number(fields, "direction", 360)));
        }
        return new Home(
                fields.get("name").strip(),
                new Position(meters(fields, "x"), meters(fields, "y")),
                Math.toRadians(number(fields, "heading", 360)),
                Optional.empty());
    }

    private static Area area(Map<String, String> fields, Area before) throws FieldRefusal {
        return Area.between(
                meters(fields, "x1"),
                meters(fields, "y1"),
                meters(fields, "x2"),
                meters(fields, "y2"),
                before.rotationRadians());
    }

    private static double meters(Map<String, String> fields, String key) throws FieldRefusal {
        return number(fields, key, MOST_METERS);
    }

    /** A decimal with a dot or a comma. */
    private static double number(Map<String, String> fields, String key, double most) throws FieldRefusal {
        String typed = fields.get(key).strip();
        String word = typed.replace(',', '.');
        if (word.matches("[-+]?([0-9]{1,9}(\\.[0-9]*)?|\\.[0-9]+)")) {
            double number = Double.parseDouble(word);
            if (Math.abs(number) <= most) {
                return number;
            }
        }
        throw new FieldRefusal(key, typed);
    }

    private static String degrees(double radians) {
        double degrees = Math.rint(Math.toDegrees(radians) * 1e6) / 1e6 % 360;
        return text(degrees < 0 ? degrees + 360 : degrees);
    }

    private static String text(double value) {
        BigDecimal number = BigDecimal.valueOf(value);
        return number.signum() == 0 ? "0" : number.stripTrailingZeros().toPlainString();
    }
}
