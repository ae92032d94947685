package simgsm.cells.town;

import java.util.List;

/**
 * A path for mobiles to walk to and fro.
 *
 * @param number of the mobile that begins to walk when it appears; empty for a path on offer
 * @param points at least two
 */
public record Walk(String name, String number, double metresPerSecond, List<TownPlace> points) {
    public Walk {
        points = List.copyOf(points);
    }

    /** The length from the first to the last point in metres. */
    public double lengthMetres() {
        double length = 0;
        for (int i = 1; i < points.size(); i++) {
            length += points.get(i - 1).distanceMetres(points.get(i));
        }
        return length;
    }
}
