package simrobot.ui.editor;

import java.util.List;
import simgsm.draw.Canvas;
import simgsm.draw.Face;
import simgsm.draw.Ink;
import simgsm.draw.Outline;
import simrobot.drawing.FloorPainter;
import simrobot.drawing.Viewport;
import simrobot.drawing.WorldPainter;
import simrobot.editor.Edits;
import simrobot.editor.Handle;
import simrobot.editor.Item;
import simrobot.robot.Pioneer2Dx;
import simrobot.simulation.RobotSnapshot;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.World;
import simrobot.world.WorldItem;

/** Paints the editor's additions to a floor: the raster, the selected item's handles, the pointer. */
final class EditorPainter {
    private final Canvas g;
    private final Viewport view;

    EditorPainter(Canvas g, Viewport view) {
        this.g = g;
        this.view = view;
    }

    /** Paints one item; surfaces are painted together. */
    void item(WorldItem item) {
        FloorPainter floor = new FloorPainter(g, view);
        World alone = World.of("", List.of(item));
        floor.markings(alone);
        floor.obstacles(alone);
    }

    /** Paints a dot at each point of the raster if they are at least 7 units apart. */
    void raster(double stepMeters) {
        double gap = stepMeters * view.pixelsPerMeter();
        if (gap < g.px(7)) {
            return;
        }
        double dot = g.px(1.2);
        Outline dots = new Outline();
        for (double row = Math.ceil(view.worldY(view.height()) / stepMeters);
                row * stepMeters <= view.worldY(0);
                row++) {
            for (double column = Math.ceil(view.worldX(0) / stepMeters);
                    column * stepMeters <= view.worldX(view.width());
                    column++) {
                double x = view.screenX(column * stepMeters);
                double y = view.screenY(row * stepMeters);
                dots.addBox(x - dot / 2, y - dot / 2, dot, dot);
            }
        }
        g.ink(Ink.CONTROL_LINE, 0.55);
        g.fill(dots);
    }

    /** Paints robots as dashed circles with their names. */
    void robots(List<RobotSnapshot> robots) {
        g.pen(1.4, 4);
        double r = Pioneer2Dx.RADIUS_METERS * view.pixelsPerMeter();
        for (RobotSnapshot robot : robots) {
            double x = view.screenX(robot.xMeters());
            double y = view.screenY(robot.yMeters());
            g.ink(Ink.ROBOT, 0.6);
            g.draw(Outline.circle(x, y, r));
            g.ink(Ink.QUIET);
            g.text(robot.name(), Face.SMALL, x, y - r - g.px(8));
        }
    }

    /** Paints a robot's circle at these homes, where it does not fit. */
    void blocked(List<Home> homes) {
        double r = Pioneer2Dx.RADIUS_METERS * view.pixelsPerMeter();
        for (Home home : homes) {
            Outline place = Outline.circle(
                    view.screenX(home.position().xMeters()),
                    view.screenY(home.position().yMeters()),
                    r);
            g.ink(Ink.DANGER, 0.25);
            g.fill(place);
            g.ink(Ink.DANGER);
            g.pen(2);
            g.draw(place);
        }
    }

    void selection(World world, Item item) {
        List<Handle> handles = Edits.handles(world, item);
        g.ink(Ink.ACCENT);
        g.pen(2.4);
        double[] xy = new double[2 * handles.size()];
        for (int i = 0; i < handles.size(); i++) {
            xy[2 * i] = view.screenX(handles.get(i).place().xMeters());
            xy[2 * i + 1] = view.screenY(handles.get(i).place().yMeters());
        }
        if (Edits.get(world, item) instanceof Home home) {
            double x = view.screenX(home.position().xMeters());
            double y = view.screenY(home.position().yMeters());
            g.draw(Outline.circle(x, y, Math.max(g.px(7), 0.34 * view.pixelsPerMeter())));
            g.line(x, y, xy[0], xy[1]);
        } else {
            g.draw(handles.size() > 2 ? Outline.polygon(xy) : Outline.polyline(xy));
        }
        g.pen(1.6);
        for (int i = 0; i < handles.size(); i++) {
            Outline knob = Outline.circle(xy[2 * i], xy[2 * i + 1], g.px(5));
            g.ink(Ink.CARD);
            g.fill(knob);
            g.ink(Ink.ACCENT);
            g.draw(knob);
        }
    }

    /** @param crossed true for a cross at the position */
    void pointer(Position at, String text, boolean crossed) {
        double x = view.screenX(at.xMeters());
        double y = view.screenY(at.yMeters());
        if (crossed) {
            double arm = g.px(7);
            g.ink(Ink.ACCENT);
            g.pen(1.4);
            g.line(x - arm, y, x + arm, y);
            g.line(x, y - arm, x, y + arm);
        }
        if (!text.isEmpty()) {
            double width = g.width(text, Face.MONO_SMALL) + g.px(16);
            double left = Math.min(x + g.px(14), view.width() - width - g.px(4));
            double top = Math.max(g.px(4), y - g.px(30));
            WorldPainter.textGround(g, Ink.CARD, 0.92, left, top, width, g.px(20));
            g.ink(Ink.TEXT);
            g.text(text, Face.MONO_SMALL, left + width / 2, top + g.px(10));
        }
    }
}
