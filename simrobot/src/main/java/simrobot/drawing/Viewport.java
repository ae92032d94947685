package simrobot.drawing;

import simrobot.world.Area;

/**
 * The visible part of the world and its scale. Converts metres, y up, to pixels, y down.
 *
 * @param centerX position of the view's centre, metres
 * @param pixelsPerMeter in logical pixels
 * @param width of the view in logical pixels
 */
public record Viewport(double centerX, double centerY, double pixelsPerMeter, double width, double height) {
    private static final double LEAST_PIXELS_PER_METER = 0.5;
    private static final double MOST_PIXELS_PER_METER = 2000;

    public Viewport {
        pixelsPerMeter = Math.max(LEAST_PIXELS_PER_METER, Math.min(MOST_PIXELS_PER_METER, pixelsPerMeter));
    }

    /**
     * A view of the area's proportions.
     *
     * @param longSide longer side in pixels
     * @param leastSide minimum of the shorter side, margins included
     */
    public static Viewport picture(Area area, double longSide, double leastSide, double margin) {
        double wide = Math.max(1, area.maxXMeters() - area.minXMeters());
        double high = Math.max(1, area.maxYMeters() - area.minYMeters());
        double scale = (longSide - 2 * margin) / Math.max(wide, high);
        double width = Math.rint(Math.max(leastSide, wide * scale + 2 * margin));
        double height = Math.rint(Math.max(leastSide, high * scale + 2 * margin));
        return fitting(area, width, height, margin);
    }

    /** A view of a whole area with a margin. */
    public static Viewport fitting(Area area, double width, double height, double marginPixels) {
        double wide = Math.max(area.maxXMeters() - area.minXMeters(), 1);
        double high = Math.max(area.maxYMeters() - area.minYMeters(), 1);
        double scale =
                Math.min(Math.max(1, width - 2 * marginPixels) / wide, Math.max(1, height - 2 * marginPixels) / high);
        double x = (area.minXMeters() + area.maxXMeters()) / 2;
        double y = (area.minYMeters() + area.maxYMeters()) / 2;
        return new Viewport(x, y, scale, width, height);
    }

    public double screenX(double xMeters) {
        return width / 2 + (xMeters - centerX) * pixelsPerMeter;
    }

    public double screenY(double yMeters) {
        return height / 2 - (yMeters - centerY) * pixelsPerMeter;
    }

    public double worldX(double screenX) {
        return centerX + (screenX - width / 2) / pixelsPerMeter;
    }

    public double worldY(double screenY) {
        return centerY - (screenY - height / 2) / pixelsPerMeter;
    }

    /** The view enlarged by a factor about a pixel. */
    public Viewport zoomedAt(double screenX, double screenY, double factor) {
        Viewport scaled = new Viewport(centerX, centerY, pixelsPerMeter * factor, width, height);
        return new Viewport(
                centerX + worldX(screenX) - scaled.worldX(screenX),
                centerY + worldY(screenY) - scaled.worldY(screenY),
                scaled.pixelsPerMeter,
                width,
                height);
    }

    /** The view with the world shifted by that many pixels. */
    public Viewport draggedBy(double dx, double dy) {
        return centeredOn(centerX - dx / pixelsPerMeter, centerY + dy / pixelsPerMeter);
    }

    public Viewport centeredOn(double xMeters, double yMeters) {
        return new Viewport(xMeters, yMeters, pixelsPerMeter, width, height);
    }

    /** A view of another size with the same centre and scale. */
    public Viewport sized(double newWidth, double newHeight) {
        return new Viewport(centerX, centerY, pixelsPerMeter, newWidth, newHeight);
    }

    /** A rectangular part of this view with the same scale. */
    public Viewport part(double left, double top, double partWidth, double partHeight) {
        return new Viewport(
                worldX(left + partWidth / 2), worldY(top + partHeight / 2), pixelsPerMeter, partWidth, partHeight);
    }

    /** True if a disc at that position is at least partly visible. */
    public boolean shows(double xMeters, double yMeters, double radiusMeters) {
        double reach = radiusMeters * pixelsPerMeter;
        double x = screenX(xMeters);
        double y = screenY(yMeters);
        return x + reach >= 0 && x - reach <= width && y + reach >= 0 && y - reach <= height;
    }
}
