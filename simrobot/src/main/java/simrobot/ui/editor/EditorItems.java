package simrobot.ui.editor;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.console.TextBundle;
import simrobot.drawing.NumberTexts;
import simrobot.editor.Edits;
import simrobot.editor.Item;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.World;

/** Items as the editor makes and names them. */
final class EditorItems {
    private static final double BELT_METERS_PER_SECOND = 0.3;

    private EditorItems() {}

    /** The world with a new item of the tool's kind, dragged from one place to another. */
    static World made(World world, EditorTool tool, double x1, double y1, double x2, double y2) {
        return switch (tool) {
            case SELECT -> world;
            case WALL -> Edits.with(world, new Segment(x1, y1, x2, y2));
            case BOX -> Edits.with(world, new Box("", Area.between(x1, y1, x2, y2, 0)));
            case TREADMILL ->
                Edits.with(world, new Treadmill(Area.between(x1, y1, x2, y2, 0), BELT_METERS_PER_SECOND, 0));
            case HOME ->
                Edits.with(
                        world,
                        new Home(
                                Edits.freeHomeName(world),
                                new Position(x1, y1),
                                heading(x1, y1, x2, y2),
                                Optional.empty()));
        };
    }

    /** In whole degrees; a mere click looks along x. */
    private static double heading(double x1, double y1, double x2, double y2) {
        return Math.toRadians(Math.rint(Math.toDegrees(Math.atan2(y2 - y1, x2 - x1))));
    }

    /** All items, walls last: there are most of them. */
    static List<Item> all(World world) {
        List<Item> items = new ArrayList<>();
        for (Item.Kind kind : List.of(Item.Kind.HOME, Item.Kind.BOX, Item.Kind.TREADMILL, Item.Kind.WALL)) {
            for (int i = 0; i < Edits.count(world, kind); i++) {
                items.add(new Item(kind, i));
            }
        }
        return items;
    }

    static String text(TextBundle texts, World world, Item item) {
        return switch (item.kind()) {
            case WALL -> {
                Segment w = world.segments().get(item.index());
                yield texts.of(
                        "editor.item.wall", place(w.x1Meters(), w.y1Meters()), place(w.x2Meters(), w.y2Meters()));
            }
            case BOX -> {
                Box box = world.boxes().get(item.index());
                yield texts.of("editor.item.box", box.name(), place(box.area().center()));
            }
            case HOME -> {
                Home home = world.homes().get(item.index());
                yield texts.of("editor.item.home", home.name(), place(home.position()));
            }
            case TREADMILL -> {
                Treadmill belt = world.treadmills().get(item.index());
                yield texts.of(
                        "editor.item.treadmill",
                        NumberTexts.fixed(belt.speedMetersPerSecond(), 2),
                        place(belt.area().center()));
            }
        };
    }

    private static String place(Position at) {
        return place(at.xMeters(), at.yMeters());
    }

    private static String place(double x, double y) {
        return NumberTexts.fixed(x, 2) + " " + NumberTexts.fixed(y, 2);
    }
}
