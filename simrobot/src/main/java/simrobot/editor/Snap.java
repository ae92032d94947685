package simrobot.editor;

import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;

/**
 * Where a place on the floor falls that was meant roughly: on a wall's end if one is near, else on the raster.
 *
 * @param stepMeters the raster; 0 for none, then to the millimetre
 */
public record Snap(double stepMeters) {
    private static final double FINEST_METERS = 0.001;

    public Snap {
        if (!(stepMeters >= 0)) {
            throw new IllegalArgumentException("a raster of " + stepMeters + ", expected 0 or more");
        }
    }

    /** To the raster; free of dust, so that files hold round millimetres. */
    public double of(double meters) {
        double step = stepMeters == 0 ? FINEST_METERS : stepMeters;
        return clean(Math.rint(meters / step) * step);
    }

    /** @param reach how near a wall's end must be to win, metres */
    public Position of(World world, double x, double y, double reach) {
        Position nearest = null;
        double best = reach;
        for (Segment wall : world.segments()) {
            for (int end = 0; end < 2; end++) {
                double ex = end == 0 ? wall.x1Meters() : wall.x2Meters();
                double ey = end == 0 ? wall.y1Meters() : wall.y2Meters();
                double away = Math.hypot(ex - x, ey - y);
                if (away < best) {
                    best = away;
                    nearest = new Position(ex, ey);
                }
            }
        }
        return nearest == null ? new Position(of(x), of(y)) : nearest;
    }

    /** From a place straight along x, y or a diagonal, whichever is nearest to where it was meant. */
    public Position straight(Position from, double x, double y) {
        double dx = x - from.xMeters();
        double dy = y - from.yMeters();
        boolean level = Math.abs(dx) > 2 * Math.abs(dy);
        boolean upright = Math.abs(dy) > 2 * Math.abs(dx);
        if (level) {
            return new Position(of(x), from.yMeters());
        }
        if (upright) {
            return new Position(from.xMeters(), of(y));
        }
        double side = of((Math.abs(dx) + Math.abs(dy)) / 2);
        return new Position(
                clean(from.xMeters() + Math.copySign(side, dx)), clean(from.yMeters() + Math.copySign(side, dy)));
    }

    /** Without the dust of the multiplication, and never minus zero. */
    private static double clean(double meters) {
        return Math.rint(meters * 1e6) / 1e6 + 0.0;
    }
}
