package simgsm.cells.radio;

import simgsm.cells.town.Hill;
import simgsm.cells.town.TownPlace;

/** Diffraction by a hill as by a knife edge (ITU-R P.526, 4.1). */
final class KnifeEdge {
    private static final double METRES_TIMES_MEGAHERTZ = 299.792458;
    /** Parameter below which an edge causes no loss. */
    private static final double CLEAR = -0.78;

    private KnifeEdge() {}

    /**
     * The additional loss in dB, 0 for a free path.
     *
     * @param fromMetres height of the antenna at one end above the plain
     * @param toMetres height of the antenna at the other end above the plain
     */
    static double decibels(
            Hill hill, TownPlace from, double fromMetres, double x, double y, double toMetres, double megahertz) {
        double dx = x - from.xMetres();
        double dy = y - from.yMetres();
        double length2 = dx * dx + dy * dy;
        if (length2 < 1) {
            return 0;
        }
        double along =
                ((hill.top().xMetres() - from.xMetres()) * dx + (hill.top().yMetres() - from.yMetres()) * dy) / length2;
        if (along <= 0.01 || along >= 0.99) {
            return 0;
        }
        double ground = hill.heightMetres(from.xMetres() + along * dx, from.yMetres() + along * dy);
        if (ground <= 0) {
            return 0;
        }
        double above = ground - (fromMetres + along * (toMetres - fromMetres));
        double length = Math.sqrt(length2);
        double near = along * length;
        double far = length - near;
        double v = above * Math.sqrt(2 * length * megahertz / (METRES_TIMES_MEGAHERTZ * near * far));
        return v <= CLEAR ? 0 : 6.9 + 20 * Math.log10(Math.sqrt((v - 0.1) * (v - 0.1) + 1) + v - 0.1);
    }
}
