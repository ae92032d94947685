package simrobot.editor;

import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;

/**
 * Snaps mouse positions to the ends of walls and to a raster.
 *
 * @param stepMeters of the raster; 0 for none, then positions are rounded to 1 mm
 */
public record Snap(double stepMeters) {
    private static final double FINEST_METERS = 0.001;

    public Snap {
        if (!(stepMeters >= 0)) {
            throw new IllegalArgumentException("a raster of " + stepMeters + ", expected 0 or more");
        }
    }

    /** A coordinate on the raster. */
    public double of(double meters) {
        double step = stepMeters == 0 ? FINEST_METERS : stepMeters;
        return rounded(Math.rint(meters / step) * step);
    }

    /** The nearest end of a wall within the reach, in metres, else the position on the raster. */
    public Position of(World world, double x, double y, double reach) {
        Position nearest = null;
        double best = reach;
        for (Segment wall : world.items(Segment.class)) {
            for (Position end : wall.handles()) {
                double away = Math.hypot(end.xMeters() - x, end.yMeters() - y);
                if (away < best) {
                    best = away;
                    nearest = end;
                }
            }
        }
        return nearest == null ? new Position(of(x), of(y)) : nearest;
    }

    /** The position moved to the nearest of the lines through another position along x, y and the diagonals. */
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
                rounded(from.xMeters() + Math.copySign(side, dx)), rounded(from.yMeters() + Math.copySign(side, dy)));
    }

    /** Rounded to 1 um against floating-point error, so that files hold round millimetres; never minus zero. */
    private static double rounded(double meters) {
        return Math.rint(meters * 1e6) / 1e6 + 0.0;
    }
}
