package simrobot.world;

/** The smallest upright rectangle around positions added one by one; metres. */
final class BoundingBox {
    private double minX = Double.POSITIVE_INFINITY;
    private double minY = Double.POSITIVE_INFINITY;
    private double maxX = Double.NEGATIVE_INFINITY;
    private double maxY = Double.NEGATIVE_INFINITY;

    void add(double x, double y) {
        minX = Math.min(minX, x);
        minY = Math.min(minY, y);
        maxX = Math.max(maxX, x);
        maxY = Math.max(maxY, y);
    }

    void add(Position place) {
        add(place.xMeters(), place.yMeters());
    }

    void add(WorldItem item) {
        item.outline().forEach(this::add);
    }

    /** The rectangle, or a default if nothing was added. */
    Area or(Area empty) {
        return minX > maxX ? empty : new Area(minX, minY, maxX, maxY, 0);
    }
}
