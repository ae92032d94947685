package simgsm.cells.ui;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** Areas of the map that a name must not cover: earlier names and marks. */
final class MapLabels {
    private final Rectangle2D map;
    private final List<Rectangle2D> taken = new ArrayList<>();

    /** @param map bounds of all names */
    MapLabels(Rectangle2D map) {
        this.map = map;
    }

    /** Adds an occupied area. */
    void take(Rectangle2D box) {
        taken.add(box);
    }

    /** The first of several places at which a name covers least, moved into the map and then occupied. */
    Rectangle2D place(List<Rectangle2D> choices) {
        Rectangle2D best = null;
        double least = Double.POSITIVE_INFINITY;
        for (Rectangle2D choice : choices) {
            Rectangle2D inside = moved(choice);
            double covered =
                    taken.stream().mapToDouble(other -> covered(inside, other)).sum();
            if (covered < least) {
                least = covered;
                best = inside;
            }
        }
        take(best);
        return best;
    }

    private Rectangle2D moved(Rectangle2D box) {
        return new Rectangle2D.Double(
                within(box.getX(), map.getMinX(), map.getMaxX() - box.getWidth()),
                within(box.getY(), map.getMinY(), map.getMaxY() - box.getHeight()),
                box.getWidth(),
                box.getHeight());
    }

    private static double within(double value, double least, double most) {
        return Math.max(least, Math.min(most, value));
    }

    private static double covered(Rectangle2D one, Rectangle2D other) {
        Rectangle2D both = one.createIntersection(other);
        return both.isEmpty() ? 0 : both.getWidth() * both.getHeight();
    }
}
