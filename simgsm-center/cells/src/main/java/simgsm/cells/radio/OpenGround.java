package simgsm.cells.radio;

import simgsm.cells.town.Tower;
import simgsm.cells.town.TownPlace;

/** Hata's urban median loss at 900 MHz for antennas at 30 m and 1.5 m, without shadowing: 126.4 dB at 1 km, 35.2 dB a decade. */
public final class OpenGround implements Radio {
    private static final double LOSS_AT_1_KM_DECIBELS = 126.4;
    private static final double DECIBELS_PER_DECADE = 35.2;
    private static final double LEAST_METRES = 10;
    /** A receiver's reference sensitivity (TS 45.005): 2 % of wrong bits there. */
    private static final double SENSITIVITY_DBM = -102;

    private static final double ERROR_RATE_THERE = 0.02;
    private static final double DECIBELS_PER_DECADE_OF_ERRORS = 4;

    public OpenGround() {}

    @Override
    public double levelDbm(Tower tower, TownPlace place) {
        double metres = Math.max(LEAST_METRES, tower.place().distanceMetres(place));
        return tower.powerDbm() - LOSS_AT_1_KM_DECIBELS - DECIBELS_PER_DECADE * Math.log10(metres / 1_000);
    }

    @Override
    public double bitErrorRate(double levelDbm, double interfererDbm) {
        double margin = (levelDbm - SENSITIVITY_DBM) / DECIBELS_PER_DECADE_OF_ERRORS;
        return Math.min(0.5, ERROR_RATE_THERE * Math.pow(10, -margin));
    }
}
