package simgsm.cells.mobile;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import simgsm.cells.town.TownPlace;

/** A position at rest or walking along points: to one point, or along several to and fro. */
public final class Walker {
    private static final double SECOND_NANOS = 1e9;

    private TownPlace place;
    private List<TownPlace> points = List.of();
    private int next;
    private double metresPerSecond;

    public Walker(TownPlace place) {
        this.place = place;
    }

    public TownPlace place() {
        return place;
    }

    /** The points ahead; empty at rest. */
    public List<TownPlace> ahead() {
        return points.isEmpty() ? List.of() : points.subList(next, points.size());
    }

    /** Speed; 0 at rest. */
    double metresPerSecond() {
        return points.isEmpty() ? 0 : metresPerSecond;
    }

    /** Stops at a new place. */
    public void standAt(TownPlace newPlace) {
        place = newPlace;
        points = List.of();
    }

    /** Walks to the first point and further; to and fro if there is more than one. */
    public void walk(List<TownPlace> along, double speedMetresPerSecond) {
        points = new ArrayList<>(along);
        next = 0;
        metresPerSecond = speedMetresPerSecond;
    }

    /** Continues another's walk from its place. */
    public void follow(Walker other) {
        place = other.place;
        points = other.points;
        next = other.next;
        metresPerSecond = other.metresPerSecond;
    }

    public void advance(long nanos) {
        double metres = metresPerSecond * nanos / SECOND_NANOS;
        while (!points.isEmpty() && metres > 0) {
            TownPlace target = points.get(next);
            double distance = place.distanceMetres(target);
            place = place.towards(target, metres);
            metres -= distance;
            if (metres >= 0) {
                reached();
            }
        }
    }

    private void reached() {
        next++;
        if (next == points.size()) {
            if (points.size() == 1) {
                points = List.of();
            } else {
                Collections.reverse(points);
                next = 1;
            }
        }
    }
}
