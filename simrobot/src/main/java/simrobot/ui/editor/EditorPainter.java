package simrobot.ui.editor;

import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;
import simrobot.editor.Edits;
import simrobot.editor.Handle;
import simrobot.editor.Item;
import simrobot.robot.Pioneer2Dx;
import simrobot.simulation.RobotSnapshot;
import simrobot.ui.floor.Viewport;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.World;

/** Paints what the editor adds to a floor: the raster, the selected item's handles, where the tool points. */
final class EditorPainter {
    private final Graphics2D g;
    private final Viewport view;

    EditorPainter(Graphics2D g, Viewport view) {
        this.g = g;
        this.view = view;
    }

    /** A dot at each place of the raster, while there is room between them. */
    void raster(double stepMeters) {
        double gap = stepMeters * view.pixelsPerMeter();
        if (gap < Theme.exact(7)) {
            return;
        }
        g.setColor(Theme.color(Ink.CONTROL_LINE, 0.55));
        double dot = Theme.exact(1.2);
        for (double row = Math.ceil(view.worldY(view.height()) / stepMeters);
                row * stepMeters <= view.worldY(0);
                row++) {
            for (double column = Math.ceil(view.worldX(0) / stepMeters);
                    column * stepMeters <= view.worldX(view.width());
                    column++) {
                double x = view.screenX(column * stepMeters);
                double y = view.screenY(row * stepMeters);
                g.fill(new Rectangle2D.Double(x - dot / 2, y - dot / 2, dot, dot));
            }
        }
    }

    /** Where robots stand, as mere circles. */
    void robots(List<RobotSnapshot> robots) {
        g.setColor(Theme.color(Ink.ROBOT, 0.6));
        g.setStroke(Theme.dashed(1.4, 4));
        double r = Pioneer2Dx.RADIUS_METERS * view.pixelsPerMeter();
        for (RobotSnapshot robot : robots) {
            double x = view.screenX(robot.xMeters());
            double y = view.screenY(robot.yMeters());
            g.draw(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r));
            g.setColor(Theme.color(Ink.QUIET));
            Drawing.centred(g, robot.name(), Theme.small(), x, y - r - Theme.exact(8));
            g.setColor(Theme.color(Ink.ROBOT, 0.6));
        }
    }

    void selection(World world, Item item) {
        List<Handle> handles = Edits.handles(world, item);
        g.setColor(Theme.color(Ink.ACCENT));
        g.setStroke(Theme.stroke(2.4));
        Path2D outline = new Path2D.Double();
        if (item.kind() == Item.Kind.HOME) {
            Home home = world.homes().get(item.index());
            double x = view.screenX(home.position().xMeters());
            double y = view.screenY(home.position().yMeters());
            double r = Math.max(Theme.exact(7), 0.34 * view.pixelsPerMeter());
            g.draw(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r));
            outline.moveTo(x, y);
        }
        for (Handle handle : handles) {
            double x = view.screenX(handle.xMeters());
            double y = view.screenY(handle.yMeters());
            if (outline.getCurrentPoint() == null) {
                outline.moveTo(x, y);
            } else {
                outline.lineTo(x, y);
            }
        }
        if (handles.size() > 2) {
            outline.closePath();
        }
        g.draw(outline);
        handles.forEach(this::handle);
    }

    private void handle(Handle handle) {
        double r = Theme.exact(5);
        double x = view.screenX(handle.xMeters());
        double y = view.screenY(handle.yMeters());
        Ellipse2D knob = new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r);
        g.setColor(Theme.color(Ink.CARD));
        g.fill(knob);
        g.setColor(Theme.color(Ink.ACCENT));
        g.setStroke(Theme.stroke(1.6));
        g.draw(knob);
    }

    /** @param crossed whether the place is marked by itself, and not only told */
    void cursor(Position at, String text, boolean crossed) {
        double x = view.screenX(at.xMeters());
        double y = view.screenY(at.yMeters());
        if (crossed) {
            double arm = Theme.exact(7);
            g.setColor(Theme.color(Ink.ACCENT));
            g.setStroke(Theme.stroke(1.4));
            Drawing.line(g, x - arm, y, x + arm, y);
            Drawing.line(g, x, y - arm, x, y + arm);
        }
        if (!text.isEmpty()) {
            double width = Drawing.width(Theme.monoSmall(), text) + Theme.exact(16);
            double left = Math.min(x + Theme.exact(14), view.width() - width - Theme.exact(4));
            double top = Math.max(Theme.exact(4), y - Theme.exact(30));
            g.setColor(Theme.color(Ink.CARD, 0.92));
            g.fill(Drawing.round(left, top, width, Theme.exact(20), Theme.exact(Theme.CONTROL_RADIUS)));
            g.setColor(Theme.color(Ink.TEXT));
            Drawing.centred(g, text, Theme.monoSmall(), left + width / 2, top + Theme.exact(10));
        }
    }
}
