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

/** An item as words and numbers that can be typed: metres, degrees, metres per second. */
public final class ItemFields {
    /** Far beyond any floor, and far within what a map file may hold. */
    private static final double MOST_METERS = 100_000;

    private static final double MOST_BELT_METERS_PER_SECOND = 10;

    private ItemFields() {}

    /** What a field that cannot be understood holds. */
    public static final class Refusal extends Exception {
        private final String field;

        Refusal(String field, String found) {
            super(found);
            this.field = field;
        }

        /** Its key. */
        public String field() {
            return field;
        }
    }

    /** The item's fields by their keys, in the order in which people read them. */
    public static Map<String, String> of(World world, Item item) {
        Map<String, String> fields = new LinkedHashMap<>();
        switch (item.kind()) {
            case WALL -> {
                Segment w = world.segments().get(item.index());
                corners(fields, w.x1Meters(), w.y1Meters(), w.x2Meters(), w.y2Meters());
            }
            case BOX -> {
                Box box = world.boxes().get(item.index());
                fields.put("name", box.name());
                corners(fields, box.area());
            }
            case HOME -> {
                Home home = world.homes().get(item.index());
                fields.put("name", home.name());
                fields.put("x", text(home.position().xMeters()));
                fields.put("y", text(home.position().yMeters()));
                fields.put("heading", degrees(home.headingRadians()));
            }
            case TREADMILL -> {
                Treadmill belt = world.treadmills().get(item.index());
                fields.put("speed", text(belt.speedMetersPerSecond()));
                fields.put("direction", degrees(belt.directionRadians()));
                corners(fields, belt.area());
            }
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

    /** The world with the item as the fields have it; what was not changed stays as it is to the last bit. */
    public static World changed(World world, Item item, Map<String, String> fields) throws Refusal {
        if (fields.equals(of(world, item))) {
            return world;
        }
        return switch (item.kind()) {
            case WALL ->
                Edits.replaced(
                        world,
                        item,
                        new Segment(
                                meters(fields, "x1"),
                                meters(fields, "y1"),
                                meters(fields, "x2"),
                                meters(fields, "y2")));
            case BOX -> {
                Box box = world.boxes().get(item.index());
                yield Edits.replaced(world, item, new Box(fields.get("name").strip(), area(fields, box.area())));
            }
            case HOME -> {
                Position at = new Position(meters(fields, "x"), meters(fields, "y"));
                double heading = Math.toRadians(number(fields, "heading", 360));
                yield Edits.replaced(world, item, new Home(fields.get("name").strip(), at, heading, Optional.empty()));
            }
            case TREADMILL -> {
                Treadmill belt = world.treadmills().get(item.index());
                yield Edits.replaced(
                        world,
                        item,
                        new Treadmill(
                                area(fields, belt.area()),
                                number(fields, "speed", MOST_BELT_METERS_PER_SECOND),
                                Math.toRadians(number(fields, "direction", 360))));
            }
        };
    }

    private static Area area(Map<String, String> fields, Area before) throws Refusal {
        return Area.between(
                meters(fields, "x1"),
                meters(fields, "y1"),
                meters(fields, "x2"),
                meters(fields, "y2"),
                before.rotationRadians());
    }

    private static double meters(Map<String, String> fields, String key) throws Refusal {
        return number(fields, key, MOST_METERS);
    }

    /** A decimal with a dot or a comma. */
    private static double number(Map<String, String> fields, String key, double most) throws Refusal {
        String typed = fields.get(key).strip();
        String word = typed.replace(',', '.');
        if (word.matches("[-+]?([0-9]{1,9}(\\.[0-9]*)?|\\.[0-9]+)")) {
            double number = Double.parseDouble(word);
            if (Math.abs(number) <= most) {
                return number;
            }
        }
        throw new Refusal(key, typed);
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
