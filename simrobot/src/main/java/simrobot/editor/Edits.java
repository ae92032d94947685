package simrobot.editor;

import java.util.ArrayList;
import java.util.List;
import simrobot.world.Box;
import simrobot.world.Home;
import simrobot.world.ItemKind;
import simrobot.world.ObstacleGrid;
import simrobot.world.Position;
import simrobot.world.World;
import simrobot.world.WorldItem;

/** Changes of a world, each as a new world. */
public final class Edits {
    private Edits() {}

    /** The last added item of a kind. */
    public static Item last(World world, ItemKind<?> kind) {
        return new Item(kind, count(world, kind) - 1);
    }

    public static int count(World world, ItemKind<?> kind) {
        return world.items(kind.type()).size();
    }

    /** True if the world has an item at the reference. */
    public static boolean has(World world, Item item) {
        return item.index() < count(world, item.kind());
    }

    public static WorldItem get(World world, Item item) {
        return world.items(item.kind().type()).get(item.index());
    }

    public static World with(World world, WorldItem added) {
        return world.toBuilder().add(added).build();
    }

    /** @param next of the same kind */
    public static World replaced(World world, Item item, WorldItem next) {
        return world.toBuilder().set(item.index(), next).build();
    }

    public static World without(World world, Item item) {
        return world.toBuilder().remove(item.kind().type(), item.index()).build();
    }

    public static World moved(World world, Item item, double dx, double dy) {
        return replaced(world, item, get(world, item).movedBy(dx, dy));
    }

    /** The homes at which a robot of this radius would overlap a wall or a box. */
    public static List<Home> blockedHomes(World world, double radiusMeters) {
        ObstacleGrid obstacles = new ObstacleGrid(world);
        return world.items(Home.class).stream()
                .filter(home -> !isFree(world, obstacles, home.position(), radiusMeters))
                .toList();
    }

    private static boolean isFree(World world, ObstacleGrid obstacles, Position at, double radiusMeters) {
        return obstacles.isFree(at.xMeters(), at.yMeters(), radiusMeters)
                && world.items(Box.class).stream().noneMatch(box -> box.area().contains(at.xMeters(), at.yMeters()));
    }

    /** The handles that change the item's shape. */
    public static List<Handle> handles(World world, Item item) {
        List<Handle> handles = new ArrayList<>();
        for (Position at : get(world, item).handles()) {
            handles.add(new Handle(item, handles.size(), at));
        }
        return handles;
    }

    /** The world with one handle of an item moved. */
    public static World pulled(World world, Handle handle, double x, double y) {
        Item item = handle.item();
        return replaced(world, item, get(world, item).pulled(handle.number(), new Position(x, y)));
    }
}
