package simgsm.cells.town;

/**
 * A hill: a round obstacle between antennas.
 *
 * @param radiusMetres at its foot
 * @param heightMetres of its top; the slope is half a period of a cosine
 */
public record Hill(String name, TownPlace top, double radiusMetres, double heightMetres) {
    /** Height of the ground at a place. */
    public double heightMetres(double xMetres, double yMetres) {
        double distance = Math.hypot(xMetres - top.xMetres(), yMetres - top.yMetres());
        return distance >= radiusMetres ? 0 : heightMetres * (1 + Math.cos(Math.PI * distance / radiusMetres)) / 2;
    }
}
