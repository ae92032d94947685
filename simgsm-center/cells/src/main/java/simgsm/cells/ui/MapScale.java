package simgsm.cells.ui;

import simgsm.cells.town.Town;
import simgsm.cells.town.TownPlace;

/**
 * The town's position in the picture: the largest that fits, centred.
 *
 * @param left pixels of the western edge
 * @param top pixels of the northern edge
 */
record MapScale(Town town, double pixelsPerMetre, double left, double top) {
    static MapScale fitting(Town town, double width, double height) {
        double scale = Math.min(width / town.widthMetres(), height / town.heightMetres());
        return new MapScale(
                town,
                Math.max(1e-6, scale),
                (width - scale * town.widthMetres()) / 2,
                (height - scale * town.heightMetres()) / 2);
    }

    double x(double metres) {
        return left + (metres - town.westMetres()) * pixelsPerMetre;
    }

    double y(double metres) {
        return top + (town.southMetres() + town.heightMetres() - metres) * pixelsPerMetre;
    }

    double width() {
        return town.widthMetres() * pixelsPerMetre;
    }

    double height() {
        return town.heightMetres() * pixelsPerMetre;
    }

    /** The place at a pixel; outside of the town the nearest place within. */
    TownPlace place(double x, double y) {
        return town.within(
                town.westMetres() + (x - left) / pixelsPerMetre,
                town.southMetres() + town.heightMetres() - (y - top) / pixelsPerMetre);
    }
}
