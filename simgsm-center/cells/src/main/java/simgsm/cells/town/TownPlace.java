package simgsm.cells.town;

/** A point of the town, metres east and north of its origin. */
public record TownPlace(double xMetres, double yMetres) {
    public double distanceMetres(TownPlace other) {
        return Math.hypot(other.xMetres - xMetres, other.yMetres - yMetres);
    }

    /** The point at a distance towards a target; at most the target itself. */
    public TownPlace towards(TownPlace target, double metres) {
        double distance = distanceMetres(target);
        if (distance <= metres) {
            return target;
        }
        double share = metres / distance;
        return new TownPlace(
                xMetres + share * (target.xMetres - xMetres), yMetres + share * (target.yMetres - yMetres));
    }
}
