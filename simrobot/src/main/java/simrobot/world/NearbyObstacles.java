package simrobot.world;

/**
 * The obstacles around a position, nearest first, for many cones from nearby positions: a cone tests only those nearer
 * than its result so far. Immutable; made by {@link ObstacleGrid#near}.
 */
public final class NearbyObstacles {
    private final ObstacleGrid grid;
    private final double x;
    private final double y;
    private final double reach;
    private final int[] items;

    /** The distance of each item from (x, y), rounded down. */
    private final float[] distances;

    NearbyObstacles(ObstacleGrid grid, double x, double y, double reach, int[] items, float[] distances) {
        this.grid = grid;
        this.x = x;
        this.y = y;
        this.reach = reach;
        this.items = items;
        this.distances = distances;
    }

    /** True if it contains all obstacles of this grid within the range from there. */
    public boolean covers(ObstacleGrid obstacles, double px, double py, double rangeMeters) {
        double dx = px - x;
        double dy = py - y;
        double spare = reach - rangeMeters;
        return grid == obstacles && spare >= 0 && dx * dx + dy * dy <= spare * spare;
    }

    /** The distance to the nearest obstacle inside a cone, at most {@code maxMeters}; the cone's field must be covered. */
    public double coneRange(Cone cone, double maxMeters) {
        double nearest = maxMeters;
        double away = cone.apexDistance(x, y);
        for (int i = 0; i < items.length && distances[i] - away < nearest; i++) {
            nearest = Math.min(nearest, grid.inCone(items[i], cone));
        }
        return nearest;
    }
}
