package simrobot.ui.floor;

import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import simgsm.draw.Ink;
import simgsm.ui.Drawing;
import simgsm.ui.Theme;
import simrobot.editor.Item;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.World;

/** Paints what stands and lies on the floor. Strokes and texts are in pixels, whatever the scale of the world. */
public final class FloorPainter {
    /** A wall's thickness, to the eye only: to wheels and sonars it has none. */
    private static final double WALL_METERS = 0.02;

    private final Graphics2D g;
    private final Viewport view;

    public FloorPainter(Graphics2D g, Viewport view) {
        this.g = g;
        this.view = view;
    }

    // ---- paper -----------------------------------------------------------------------------------------------------

    void paper() {
        g.setColor(Theme.color(Ink.FLOOR));
        g.fill(new Rectangle2D.Double(0, 0, view.width(), view.height()));
    }

    /** Lines every metre, stronger every five; coarser when they would crowd. */
    void grid() {
        double step = 1;
        while (step * view.pixelsPerMeter() < Theme.exact(9)) {
            step *= 5;
        }
        for (int pass = 0; pass < 2; pass++) {
            g.setColor(Theme.color(pass == 0 ? Ink.GRID_LINE : Ink.GRID_MAJOR));
            verticals(step, pass == 1);
            horizontals(step, pass == 1);
        }
    }

    private void verticals(double step, boolean major) {
        long last = (long) Math.floor(view.worldX(view.width()) / step);
        for (long i = (long) Math.ceil(view.worldX(0) / step); i <= last; i++) {
            if (i % 5 == 0 == major) {
                Drawing.vertical(g, view.screenX(i * step), 0, view.height());
            }
        }
    }

    private void horizontals(double step, boolean major) {
        long last = (long) Math.floor(view.worldY(0) / step);
        for (long i = (long) Math.ceil(view.worldY(view.height()) / step); i <= last; i++) {
            if (i % 5 == 0 == major) {
                Drawing.horizontal(g, 0, view.width(), view.screenY(i * step));
            }
        }
    }

    // ---- obstacles -------------------------------------------------------------------------------------------------

    void obstacles(World world) {
        world.boxes().forEach(this::box);
        asWalls();
        for (Segment wall : world.segments()) {
            line(wall);
        }
        points(world);
    }

    private void asWalls() {
        g.setColor(Theme.color(Ink.WALL));
        double width = Math.max(Theme.exact(1.6), WALL_METERS * view.pixelsPerMeter());
        g.setStroke(Theme.stroke(width / Theme.zoom()));
    }

    /** One thing by itself, as it looks among the others; treadmills run, and are not painted here. */
    public void item(World world, Item item) {
        switch (item.kind()) {
            case WALL -> {
                asWalls();
                line(world.segments().get(item.index()));
            }
            case BOX -> box(world.boxes().get(item.index()));
            case HOME -> home(world.homes().get(item.index()));
            case TREADMILL -> {
                // among those that run
            }
        }
    }

    private void line(Segment s) {
        double x1 = view.screenX(s.x1Meters());
        double y1 = view.screenY(s.y1Meters());
        double x2 = view.screenX(s.x2Meters());
        double y2 = view.screenY(s.y2Meters());
        boolean outside = Math.max(x1, x2) < -20
                || Math.min(x1, x2) > view.width() + 20
                || Math.max(y1, y2) < -20
                || Math.min(y1, y2) > view.height() + 20;
        if (!outside) {
            Drawing.line(g, x1, y1, x2, y2);
        }
    }

    private void points(World world) {
        double side = Math.max(Theme.exact(1.5), world.pointDiameterMeters() * view.pixelsPerMeter());
        Rectangle2D.Double dot = new Rectangle2D.Double(0, 0, side, side);
        for (Position p : world.points()) {
            if (view.shows(p.xMeters(), p.yMeters(), 0)) {
                dot.x = view.screenX(p.xMeters()) - side / 2;
                dot.y = view.screenY(p.yMeters()) - side / 2;
                g.fill(dot);
            }
        }
    }

    private void box(Box box) {
        Shape outline = outline(box.area());
        g.setColor(Theme.color(Ink.GRID_MAJOR, 0.75));
        g.fill(outline);
        g.setColor(Theme.color(Ink.WALL));
        g.setStroke(Theme.stroke(1.4));
        g.draw(outline);
        boxName(box);
    }

    /** Along the longer side when it does not fit across. */
    private void boxName(Box box) {
        double wide = (box.area().maxXMeters() - box.area().minXMeters()) * view.pixelsPerMeter();
        double high = (box.area().maxYMeters() - box.area().minYMeters()) * view.pixelsPerMeter();
        Position middle = box.area().center();
        boolean across = Drawing.width(Theme.small(), box.name()) <= wide - Theme.exact(4) || wide >= high;
        AffineTransform before = g.getTransform();
        if (!across) {
            g.rotate(-Math.PI / 2, view.screenX(middle.xMeters()), view.screenY(middle.yMeters()));
        }
        caption(box.name(), middle, 0, across ? wide : high, Ink.QUIET);
        g.setTransform(before);
    }

    // ---- what does not stop anybody
    // ----------------------------------------------------------------------------------

    void markings(World world) {
        world.forbiddenAreas().forEach(this::forbidden);
        g.setColor(Theme.color(Ink.DANGER, 0.7));
        g.setStroke(Theme.dashed(1.4, 6));
        world.forbiddenLines().forEach(this::line);
        world.homes().forEach(this::home);
        world.goals().forEach(this::goal);
    }

    private void forbidden(Area area) {
        Shape outline = outline(area);
        Graphics2D inside = (Graphics2D) g.create();
        try {
            inside.setColor(Theme.color(Ink.DANGER, 0.06));
            inside.fill(outline);
            inside.setColor(Theme.color(Ink.DANGER, 0.25));
            inside.setStroke(Theme.hairline());
            inside.clip(outline);
            Rectangle2D box = outline.getBounds2D();
            for (double x = box.getMinX() - box.getHeight(); x < box.getMaxX(); x += Theme.exact(9)) {
                Drawing.line(inside, x, box.getMaxY(), x + box.getHeight(), box.getMinY());
            }
        } finally {
            inside.dispose();
        }
        g.setColor(Theme.color(Ink.DANGER, 0.7));
        g.setStroke(Theme.dashed(1.4, 6));
        g.draw(outline);
    }

    public void treadmills(World world, long timeNanos) {
        world.treadmills().forEach(belt -> treadmill(belt, timeNanos));
    }

    /** Chevrons that run with the belt, at its speed in simulated time. */
    private void treadmill(Treadmill belt, long timeNanos) {
        Shape outline = outline(belt.area());
        Graphics2D inside = (Graphics2D) g.create();
        try {
            inside.setColor(Theme.color(Ink.ACCENT, 0.07));
            inside.fill(outline);
            inside.clip(outline);
            chevrons(inside, belt, outline.getBounds2D(), timeNanos);
        } finally {
            inside.dispose();
        }
        g.setColor(Theme.color(Ink.ACCENT, 0.6));
        g.setStroke(Theme.stroke(1.2));
        g.draw(outline);
    }

    private void chevrons(Graphics2D inside, Treadmill belt, Rectangle2D box, long timeNanos) {
        double spacing = 0.5 * view.pixelsPerMeter();
        double size = Math.min(0.16 * view.pixelsPerMeter(), Theme.exact(14));
        if (spacing < Theme.exact(8) || belt.speedMetersPerSecond() == 0) {
            return;
        }
        double ahead = Math.signum(belt.speedMetersPerSecond());
        double run = Math.abs(belt.speedMetersPerSecond()) * (timeNanos * 1e-9) % 0.5 * view.pixelsPerMeter();
        inside.setColor(Theme.color(Ink.ACCENT, 0.35));
        inside.setStroke(Theme.stroke(1.6));
        inside.translate(box.getCenterX(), box.getCenterY());
        inside.rotate(-belt.directionRadians());
        inside.scale(ahead, 1);
        double reach = Math.hypot(box.getWidth(), box.getHeight()) / 2 + spacing;
        int across = (int) (reach / spacing);
        for (double x = -across * spacing + run; x < reach; x += spacing) {
            for (double y = -across * spacing; y < reach; y += spacing) {
                chevron(inside, x, y, size);
            }
        }
    }

    private static void chevron(Graphics2D g, double x, double y, double size) {
        Path2D path = new Path2D.Double();
        path.moveTo(x - size / 2, y - size / 2);
        path.lineTo(x, y);
        path.lineTo(x - size / 2, y + size / 2);
        g.draw(path);
    }

    private void home(Home home) {
        home.area().ifPresent(area -> {
            g.setColor(Theme.color(Ink.GOOD, 0.5));
            g.setStroke(Theme.dashed(1.2, 5));
            g.draw(outline(area));
        });
        double x = view.screenX(home.position().xMeters());
        double y = view.screenY(home.position().yMeters());
        double r = Math.max(Theme.exact(5), 0.3 * view.pixelsPerMeter());
        g.setColor(Theme.color(Ink.GOOD, 0.55));
        g.setStroke(Theme.dashed(1.2, 4));
        g.draw(new Ellipse2D.Double(x - r, y - r, 2 * r, 2 * r));
        g.setStroke(Theme.stroke(1.2));
        double ux = Math.cos(home.headingRadians());
        double uy = -Math.sin(home.headingRadians());
        Drawing.line(g, x + ux * r, y + uy * r, x + ux * (r + Theme.exact(6)), y + uy * (r + Theme.exact(6)));
        caption(home.name(), home.position(), r + Theme.exact(11), Double.MAX_VALUE, Ink.GOOD);
    }

    private void goal(Goal goal) {
        double x = view.screenX(goal.position().xMeters());
        double y = view.screenY(goal.position().yMeters());
        double r = Theme.exact(4);
        Path2D diamond = new Path2D.Double();
        diamond.moveTo(x, y - r);
        diamond.lineTo(x + r, y);
        diamond.lineTo(x, y + r);
        diamond.lineTo(x - r, y);
        diamond.closePath();
        g.setColor(Theme.color(Ink.QUIET, 0.8));
        g.setStroke(Theme.stroke(1.2));
        g.draw(diamond);
        caption(goal.name(), goal.position(), Theme.exact(13), Double.MAX_VALUE, Ink.QUIET);
    }

    /** A small name, left out when the world is too small on the screen to be read anyway. */
    private void caption(String text, Position at, double below, double room, Ink ink) {
        if (!text.isEmpty()
                && view.pixelsPerMeter() >= Theme.exact(22)
                && Drawing.width(Theme.small(), text) <= room - Theme.exact(4)) {
            g.setColor(Theme.color(ink));
            Drawing.centred(g, text, Theme.small(), view.screenX(at.xMeters()), view.screenY(at.yMeters()) + below);
        }
    }

    private Shape outline(Area area) {
        List<Position> corners = area.corners();
        Path2D path = new Path2D.Double();
        for (Position corner : corners) {
            double x = view.screenX(corner.xMeters());
            double y = view.screenY(corner.yMeters());
            if (path.getCurrentPoint() == null) {
                path.moveTo(x, y);
            } else {
                path.lineTo(x, y);
            }
        }
        path.closePath();
        return path;
    }
}
