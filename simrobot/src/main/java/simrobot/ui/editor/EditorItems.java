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
import simrobot.world.WorldItem;

/** Makes new items and describes items in words. */
final class EditorItems {
    private static final double BELT_METERS_PER_SECOND = 0.3;

    private EditorItems() {}

    /** The world with a new item of the tool's kind between two places. */
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

    /** In whole degrees; 0 when both places are the same. */
    private static double heading(double x1, double y1, double x2, double y2) {
        return Math.toRadians(Math.rint(Math.toDegrees(Math.atan2(y2 - y1, x2 - x1))));
    }

    /** All items; walls last, because most items are walls. */
    static List<Item> all(World world) {
        List<Item> items = new ArrayList<>();
        for (Item.Kind kind : List.of(Item.Kind.HOME, Item.Kind.BOX, Item.Kind.TREADMILL, Item.Kind.WALL)) {
            for (int i = 0; i < Edits.count(world, kind); i++) {
                items.add(new Item(kind, i));
            }
        }
        return items;
    }

    static String text(TextBundle texts, WorldItem item) {
        if (item instanceof Segment wall) {
            return texts.of(
                    "editor.item.wall",
                    place(wall.handles().get(0)),
                    place(wall.handles().get(1)));
        }
        if (item instanceof Box box) {
            return texts.of("editor.item.box", box.name(), place(box.area().center()));
        }
        if (item instanceof Treadmill belt) {
            String speed = NumberTexts.fixed(belt.speedMetersPerSecond(), 2);
            return texts.of("editor.item.treadmill", speed, place(belt.area().center()));
        }
        Home home = (Home) item;
        return texts.of("editor.item.home", home.name(), place(home.position()));
    }

    private static String place(Position at) {
        return NumberTexts.fixed(at.xMeters(), 2) + " " + NumberTexts.fixed(at.yMeters(), 2);
    }
}
