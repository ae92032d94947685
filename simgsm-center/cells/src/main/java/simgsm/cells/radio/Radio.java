package simgsm.cells.radio;

import simgsm.cells.town.Tower;
import simgsm.cells.town.TownPlace;

/** The radio channel between towers and mobiles, alike in both directions; asked for each mobile and tower every 480 ms. */
public interface Radio {
    /** The level at which a mobile at this place receives the tower, and the tower the mobile at the same power. */
    double levelDbm(Tower tower, TownPlace place);

    /**
     * The share of wrong bits, 0 to 0.5, on a channel of this tower.
     *
     * @param interfererDbm level of all other carriers of the same frequency together; negative infinity for none
     */
    double bitErrorRate(double levelDbm, double interfererDbm);
}
