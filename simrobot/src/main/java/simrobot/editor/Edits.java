package simrobot.editor;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.World;

/** Makes one world of another; nothing is changed in place. */
public final class Edits {
    /** How far from its middle a home shows its heading. */
    static final double HEADING_HANDLE_METERS = 0.6;

    private Edits() {}

    // ---- new -------------------------------------------------------------------------------------------------------

    /** The item that comes last of its kind; it is the one that was added last. */
    public static Item last(World world, Item.Kind kind) {
        return new Item(kind, count(world, kind) - 1);
    }

    public static int count(World world, Item.Kind kind) {
        return switch (kind) {
            case WALL -> world.segments().size();
            case BOX -> world.boxes().size();
            case HOME -> world.homes().size();
            case TREADMILL -> world.treadmills().size();
        };
    }

    /** True when the world still has it. */
    public static boolean has(World world, Item item) {
        return item.index() < count(world, item.kind());
    }

    public static World with(World world, Segment wall) {
        return world.withSegments(added(world.segments(), wall));
    }

    public static World with(World world, Box box) {
        return world.withBoxes(added(world.boxes(), box));
    }

    public static World with(World world, Home home) {
        return world.withHomes(added(world.homes(), home));
    }

    public static World with(World world, Treadmill belt) {
        return world.withTreadmills(added(world.treadmills(), belt));
    }

    /** A name that no home has yet. */
    public static String freeHomeName(World world) {
        int number = world.homes().size() + 1;
        while (hasHome(world, "Home" + number)) {
            number++;
        }
        return "Home" + number;
    }

    private static boolean hasHome(World world, String name) {
        return world.homes().stream().anyMatch(home -> home.name().equals(name));
    }

    // ---- changed ---------------------------------------------------------------------------------------------------

    public static World replaced(World world, Item item, Segment wall) {
        return world.withSegments(replaced(world.segments(), item.index(), wall));
    }

    public static World replaced(World world, Item item, Box box) {
        return world.withBoxes(replaced(world.boxes(), item.index(), box));
    }

    public static World replaced(World world, Item item, Home home) {
        return world.withHomes(replaced(world.homes(), item.index(), home));
    }

    public static World replaced(World world, Item item, Treadmill belt) {
        return world.withTreadmills(replaced(world.treadmills(), item.index(), belt));
    }

    public static World without(World world, Item item) {
        int i = item.index();
        return switch (item.kind()) {
            case WALL -> world.withSegments(removed(world.segments(), i));
            case BOX -> world.withBoxes(removed(world.boxes(), i));
            case HOME -> world.withHomes(removed(world.homes(), i));
            case TREADMILL -> world.withTreadmills(removed(world.treadmills(), i));
        };
    }

    public static World moved(World world, Item item, double dx, double dy) {
        return switch (item.kind()) {
            case WALL -> {
                Segment w = world.segments().get(item.index());
                yield replaced(
                        world,
                        item,
                        new Segment(
                                sum(w.x1Meters(), dx),
                                sum(w.y1Meters(), dy),
                                sum(w.x2Meters(), dx),
                                sum(w.y2Meters(), dy)));
            }
            case BOX -> {
                Box box = world.boxes().get(item.index());
                yield replaced(world, item, new Box(box.name(), box.area().movedBy(dx, dy)));
            }
            case HOME -> {
                Home home = world.homes().get(item.index());
                Position at = home.position();
                yield replaced(
                        world,
                        item,
                        new Home(
                                home.name(),
                                new Position(sum(at.xMeters(), dx), sum(at.yMeters(), dy)),
                                home.headingRadians(),
                                home.area().map(area -> area.movedBy(dx, dy))));
            }
            case TREADMILL -> {
                Treadmill belt = world.treadmills().get(item.index());
                yield replaced(
                        world,
                        item,
                        new Treadmill(
                                belt.area().movedBy(dx, dy), belt.speedMetersPerSecond(), belt.directionRadians()));
            }
        };
    }

    /** Free of the dust that adding decimals leaves: a file is to hold 300 mm, not 300.00000000000004. */
    private static double sum(double meters, double more) {
        return more == 0 ? meters : Math.rint((meters + more) * 1e9) / 1e9;
    }

    // ---- handles ---------------------------------------------------------------------------------------------------

    /** Where the item is taken to change its shape. */
    public static List<Handle> handles(World world, Item item) {
        return switch (item.kind()) {
            case WALL -> {
                Segment w = world.segments().get(item.index());
                yield List.of(
                        new Handle(item, 0, w.x1Meters(), w.y1Meters()),
                        new Handle(item, 1, w.x2Meters(), w.y2Meters()));
            }
            case BOX -> corners(item, world.boxes().get(item.index()).area());
            case TREADMILL -> corners(item, world.treadmills().get(item.index()).area());
            case HOME -> {
                Home home = world.homes().get(item.index());
                yield List.of(new Handle(
                        item,
                        0,
                        home.position().xMeters() + HEADING_HANDLE_METERS * Math.cos(home.headingRadians()),
                        home.position().yMeters() + HEADING_HANDLE_METERS * Math.sin(home.headingRadians())));
            }
        };
    }

    private static List<Handle> corners(Item item, Area area) {
        List<Handle> handles = new ArrayList<>();
        for (Position corner : area.corners()) {
            handles.add(new Handle(item, handles.size(), corner.xMeters(), corner.yMeters()));
        }
        return handles;
    }

    /** The handle pulled to a place. */
    public static World pulled(World world, Handle handle, double x, double y) {
        Item item = handle.item();
        return switch (item.kind()) {
            case WALL -> {
                Segment w = world.segments().get(item.index());
                yield replaced(
                        world,
                        item,
                        handle.number() == 0
                                ? new Segment(x, y, w.x2Meters(), w.y2Meters())
                                : new Segment(w.x1Meters(), w.y1Meters(), x, y));
            }
            case BOX -> {
                Box box = world.boxes().get(item.index());
                yield replaced(world, item, new Box(box.name(), pulled(box.area(), handle.number(), x, y)));
            }
            case TREADMILL -> {
                Treadmill belt = world.treadmills().get(item.index());
                yield replaced(
                        world,
                        item,
                        new Treadmill(
                                pulled(belt.area(), handle.number(), x, y),
                                belt.speedMetersPerSecond(),
                                belt.directionRadians()));
            }
            case HOME -> {
                Home home = world.homes().get(item.index());
                double towards = Math.atan2(
                        y - home.position().yMeters(), x - home.position().xMeters());
                double degrees = Math.rint(Math.toDegrees(towards));
                yield replaced(
                        world, item, new Home(home.name(), home.position(), Math.toRadians(degrees), Optional.empty()));
            }
        };
    }

    /** The corner opposite stays where it is. @param corner as {@link Area#corners} counts them */
    private static Area pulled(Area area, int corner, double x, double y) {
        Position to = area.local(x, y);
        boolean left = corner == 0 || corner == 3;
        boolean low = corner <= 1;
        return Area.between(
                to.xMeters(),
                to.yMeters(),
                left ? area.maxXMeters() : area.minXMeters(),
                low ? area.maxYMeters() : area.minYMeters(),
                area.rotationRadians());
    }

    // ---- lists -----------------------------------------------------------------------------------------------------

    private static <T> List<T> added(List<T> list, T one) {
        List<T> longer = new ArrayList<>(list.size() + 1);
        longer.addAll(list);
        longer.add(one);
        return longer;
    }

    private static <T> List<T> replaced(List<T> list, int index, T one) {
        List<T> changed = new ArrayList<>(list);
        changed.set(index, one);
        return changed;
    }

    private static <T> List<T> removed(List<T> list, int index) {
        List<T> shorter = new ArrayList<>(list);
        shorter.remove(index);
        return shorter;
    }
}
