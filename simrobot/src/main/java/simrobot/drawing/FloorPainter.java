package simrobot.drawing;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
import simgsm.draw.Canvas;
import simgsm.draw.Face;
import simgsm.draw.Ink;
import simgsm.draw.Outline;
import simrobot.simulation.RobotSnapshot;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.ForbiddenArea;
import simrobot.world.ForbiddenLine;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.Point;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.Surface;
import simrobot.world.World;

/** Paints the floor and its objects. Strokes and texts keep their size in pixels at every scale. */
public final class FloorPainter {
    /** A wall's thickness in the picture; wheels and sonars see none. */
    private static final double WALL_METERS = 0.02;

    private static final double CHEVRON_SPACING_METERS = 0.5;
    private static final double CHEVRON_METERS = 0.16;
    private static final double HOME_RADIUS_METERS = 0.3;
    /** Scale below which names are omitted, in pixels per metre at zoom 1. */
    private static final double LEAST_NAMED_SCALE = 22;
    /** The height of a row of a name. */
    private static final double NAME_ROW_UNITS = 14;
    /** Maximum width of a name's plate relative to its box. */
    private static final double WIDEST_PLATE = 1.8;

    private final Canvas g;
    private final Viewport view;
    private final PlaceNames names;

    /** Creates a painter with names as in the world's file. */
    public FloorPainter(Canvas g, Viewport view) {
        this(g, view, PlaceNames.OF_FILE);
    }

    FloorPainter(Canvas g, Viewport view, PlaceNames names) {
        this.g = g;
        this.view = view;
        this.names = names;
    }

    // ---- paper -----------------------------------------------------------------------------------------------------

    void paper() {
        g.ink(Ink.FLOOR);
        g.fill(Outline.box(0, 0, view.width(), view.height()));
    }

    /** Draws lines every metre, stronger every five; every 5 m, 25 m ... if they would be closer than 9 units. */
    void grid() {
        double step = 1;
        while (step * view.pixelsPerMeter() < g.px(9)) {
            step *= 5;
        }
        gridLines(step, false);
        gridLines(step, true);
    }

    private void gridLines(double step, boolean major) {
        g.ink(major ? Ink.GRID_MAJOR : Ink.GRID_LINE);
        long right = (long) Math.floor(view.worldX(view.width()) / step);
        for (long i = (long) Math.ceil(view.worldX(0) / step); i <= right; i++) {
            if (i % 5 == 0 == major) {
                g.bar(view.screenX(i * step), 0, g.px(1), view.height());
            }
        }
        long top = (long) Math.floor(view.worldY(0) / step);
        for (long i = (long) Math.ceil(view.worldY(view.height()) / step); i <= top; i++) {
            if (i % 5 == 0 == major) {
                g.bar(0, view.screenY(i * step), view.width(), g.px(1));
            }
        }
    }

    // ---- obstacles -------------------------------------------------------------------------------------------------

    public void obstacles(World world) {
        double middle = world.bounds().center().yMeters();
        world.items(Box.class).forEach(box -> box(box, middle));
        walls(world.items(Segment.class));
        points(world);
    }

    private void walls(List<Segment> walls) {
        g.ink(Ink.WALL);
        g.pen(Math.max(1.6, WALL_METERS * view.pixelsPerMeter() / g.px(1)));
        walls.forEach(this::line);
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
            g.line(x1, y1, x2, y2);
        }
    }

    /** Draws a square for each point; only one per pixel. */
    private void points(World world) {
        double side = Math.max(g.px(1.5), world.pointDiameterMeters() * view.pixelsPerMeter());
        Outline squares = new Outline();
        Set<Long> drawn = new HashSet<>();
        for (Point p : world.items(Point.class)) {
            double x = view.screenX(p.xMeters());
            double y = view.screenY(p.yMeters());
            if (view.shows(p.xMeters(), p.yMeters(), 0) && drawn.add(Math.round(x) << 32 | Math.round(y))) {
                squares.addBox(x - side / 2, y - side / 2, side, side);
            }
        }
        g.fill(squares);
    }

    private void box(Box box, double middleYMeters) {
        Outline outline = outline(box.area());
        g.ink(Ink.GRID_MAJOR, 0.75);
        g.fill(outline);
        g.ink(Ink.WALL);
        g.pen(1.4);
        g.draw(outline);
        boxName(box, middleYMeters);
    }

    /**
     * Draws the name; turned by 90 degrees if it does not fit across and the box is higher than wide; in two rows, or
     * on a plate beside the box, towards the world's middle, if it does not fit either way.
     */
    private void boxName(Box box, double middleYMeters) {
        double wide = (box.area().maxXMeters() - box.area().minXMeters()) * view.pixelsPerMeter();
        double high = (box.area().maxYMeters() - box.area().minYMeters()) * view.pixelsPerMeter();
        String shown = names.of(box.name());
        double length = g.width(shown, Face.SMALL) + g.px(4);
        boolean across = length <= wide || wide >= high;
        Position middle = box.area().center();
        double x = view.screenX(middle.xMeters());
        double y = view.screenY(middle.yMeters());
        if (length > Math.max(wide, high)) {
            longName(shown, x, y, wide, middle.yMeters() < middleYMeters ? -high : high);
        } else if (across) {
            name(shown, x, y, wide, Ink.QUIET);
        } else {
            g.moved(x, y, -Math.PI / 2, () -> name(shown, 0, 0, high, Ink.QUIET));
        }
    }

    /** @param high negative to set the plate above the box */
    private void longName(String name, double x, double y, double wide, double high) {
        int blank = name.indexOf(' ', name.length() / 2 - 1);
        String first = name.substring(0, Math.max(0, blank));
        String second = name.substring(blank + 1);
        double step = g.px(NAME_ROW_UNITS);
        double length = g.width(name, Face.SMALL) + g.px(8);
        double longer = Math.max(g.width(first, Face.SMALL), g.width(second, Face.SMALL)) + g.px(4);
        if (blank > 0 && longer <= wide && 2 * step <= Math.abs(high)) {
            name(first, x, y - step / 2, wide, Ink.QUIET);
            name(second, x, y + step / 2, wide, Ink.QUIET);
        } else if (length <= wide * WIDEST_PLATE && isNamed(name)) {
            double row = y + high / 2 + Math.copySign(step / 2 + g.px(2), high);
            WorldPainter.textGround(g, Ink.FLOOR, 0.85, x - length / 2, row - step / 2, length, step);
            name(name, x, row, length, Ink.QUIET);
        }
    }

    // ---- markings: they stop neither wheels nor sonars -------------------------------------------------------------

    public void markings(World world) {
        world.items(ForbiddenArea.class).forEach(forbidden -> forbidden(forbidden.area()));
        g.ink(Ink.DANGER, 0.7);
        g.pen(1.4, 6);
        world.items(ForbiddenLine.class).forEach(forbidden -> line(forbidden.line()));
        world.items(Home.class).forEach(this::home);
        world.items(Goal.class).forEach(this::goal);
    }

    private void forbidden(Area area) {
        Outline outline = outline(area);
        g.clipped(outline, () -> {
            g.ink(Ink.DANGER, 0.06);
            g.fill(outline);
            g.ink(Ink.DANGER, 0.25);
            g.pen(1);
            g.draw(hatching(area));
        });
        g.ink(Ink.DANGER, 0.7);
        g.pen(1.4, 6);
        g.draw(outline);
    }

    /** Diagonals every 9 units over the rectangle around an area. */
    private Outline hatching(Area area) {
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double top = Double.POSITIVE_INFINITY;
        double low = Double.NEGATIVE_INFINITY;
        for (Position corner : area.corners()) {
            left = Math.min(left, view.screenX(corner.xMeters()));
            right = Math.max(right, view.screenX(corner.xMeters()));
            top = Math.min(top, view.screenY(corner.yMeters()));
            low = Math.max(low, view.screenY(corner.yMeters()));
        }
        Outline lines = new Outline();
        for (double x = left - (low - top); x < right; x += g.px(9)) {
            lines.move(x, low).line(x + low - top, top);
        }
        return lines;
    }

    /** Draws surfaces; on a moving one chevrons move with it, at its speed in simulated time. */
    public void surfaces(World world, long timeNanos) {
        world.surfaces().forEach(surface -> surface(surface, timeNanos));
    }

    private void surface(Surface surface, long timeNanos) {
        Outline outline = outline(surface.area());
        g.clipped(outline, () -> {
            g.ink(Ink.ACCENT, 0.07);
            g.fill(outline);
            if (surface.isMoving()) {
                chevrons(surface, timeNanos);
            }
        });
        g.ink(Ink.ACCENT, 0.6);
        g.pen(1.2);
        g.draw(outline);
    }

    private void chevrons(Surface belt, long timeNanos) {
        double spacing = CHEVRON_SPACING_METERS * view.pixelsPerMeter();
        double speed = Math.hypot(belt.velocityX(), belt.velocityY());
        if (spacing < g.px(8)) {
            return;
        }
        double size = Math.min(CHEVRON_METERS * view.pixelsPerMeter(), g.px(14));
        double run = speed * (timeNanos * 1e-9) % CHEVRON_SPACING_METERS * view.pixelsPerMeter();
        double wide = belt.area().maxXMeters() - belt.area().minXMeters();
        double high = belt.area().maxYMeters() - belt.area().minYMeters();
        double reach = Math.hypot(wide, high) / 2 * view.pixelsPerMeter() + spacing;
        int across = (int) (reach / spacing);
        Outline chevrons = new Outline();
        for (double x = -across * spacing + run; x < reach; x += spacing) {
            for (double y = -across * spacing; y < reach; y += spacing) {
                chevrons.move(x - size / 2, y - size / 2).line(x, y).line(x - size / 2, y + size / 2);
            }
        }
        Position middle = belt.area().center();
        g.moved(
                view.screenX(middle.xMeters()),
                view.screenY(middle.yMeters()),
                -Math.atan2(belt.velocityY(), belt.velocityX()),
                () -> {
                    g.ink(Ink.ACCENT, 0.35);
                    g.pen(1.6);
                    g.draw(chevrons);
                });
    }

    private void home(Home home) {
        home.area().ifPresent(area -> {
            g.ink(Ink.GOOD, 0.5);
            g.pen(1.2, 5);
            g.draw(outline(area));
        });
        double x = view.screenX(home.position().xMeters());
        double y = view.screenY(home.position().yMeters());
        double r = homeRadius();
        g.ink(Ink.GOOD, 0.55);
        g.pen(1.2, 4);
        g.draw(Outline.circle(x, y, r));
        g.pen(1.2);
        double ux = Math.cos(home.headingRadians());
        double uy = -Math.sin(home.headingRadians());
        g.line(x + ux * r, y + uy * r, x + ux * (r + g.px(6)), y + uy * (r + g.px(6)));
    }

    /** Draws names of homes, except those of named robots, which bear the same name. */
    public void homeNames(World world, List<RobotSnapshot> named) {
        for (Home home : world.items(Home.class)) {
            Position at = home.position();
            if (named.stream().noneMatch(robot -> robot.name().equals(home.name()))) {
                double y = view.screenY(at.yMeters()) + homeRadius() + g.px(11);
                name(names.of(home.name()), view.screenX(at.xMeters()), y, Double.MAX_VALUE, Ink.GOOD);
            }
        }
    }

    private double homeRadius() {
        return Math.max(g.px(5), HOME_RADIUS_METERS * view.pixelsPerMeter());
    }

    private void goal(Goal goal) {
        double x = view.screenX(goal.position().xMeters());
        double y = view.screenY(goal.position().yMeters());
        double r = g.px(4);
        g.ink(Ink.QUIET, 0.8);
        g.pen(1.2);
        g.draw(Outline.polygon(x, y - r, x + r, y, x, y + r, x - r, y));
        name(names.of(goal.name()), x, y + g.px(13), Double.MAX_VALUE, Ink.QUIET);
    }

    /** Draws a small name; omitted if it is wider than its space or the scale is too small. */
    private void name(String name, double x, double y, double room, Ink ink) {
        if (isNamed(name) && g.width(name, Face.SMALL) <= room - g.px(4)) {
            g.ink(ink);
            g.text(name, Face.SMALL, x, y);
        }
    }

    private boolean isNamed(String name) {
        return !name.isEmpty() && view.pixelsPerMeter() >= g.px(LEAST_NAMED_SCALE);
    }

    private Outline outline(Area area) {
        return Outline.polygon(area.corners().stream()
                .flatMapToDouble(
                        corner -> DoubleStream.of(view.screenX(corner.xMeters()), view.screenY(corner.yMeters())))
                .toArray());
    }
}
