package simgsm.cells.mobile;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import simgsm.cells.town.TownPlace;

/** A position that stands still or walks along points: to one point and stops there, or along several to and fro. */
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

    /** The points ahead; empty if it stands. */
    public List<TownPlace> ahead() {
        return points.isEmpty() ? List.of() : points.subList(next, points.size());
    }

    /** 0 while it stands. */
    double metresPerSecond() {
        return points.isEmpty() ? 0 : metresPerSecond;
    }

    /** Stands here from now on. */
    public void standAt(TownPlace newPlace) {
        place = newPlace;
        points = List.of();
    }

    /** Walks from here to the first point and on; to and fro if there is more than one. */
    public void walk(List<TownPlace> along, double speedMetresPerSecond) {
        points = new ArrayList<>(along);
        next = 0;
        metresPerSecond = speedMetresPerSecond;
    }

    /** Goes on where another is and walks. */
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
