package simgsm.cells.radio;

import simgsm.cells.town.Clutter;

/**
 * Median path loss between a tower and a mobile: Okumura-Hata below 1500 MHz, COST 231-Hata above (COST 231 final
 * report, 4.4); valid for 150 to 2000 MHz, towers of 30 to 200 m and distances of 1 to 20 km.
 *
 * <p>Below 1 km the same slope continues down to the loss of free space, the minimum at any distance.
 */
public final class PathLoss {
    private static final double COST_231_FROM_MEGAHERTZ = 1_500;
    /** Minimum distance of the formulas: a mobile at the foot of the tower. */
    private static final double NEAREST_METRES = 10;

    private final double atOneKilometerDecibels;
    private final double perDecadeDecibels;
    private final double freeSpaceDecibels;

    /**
     * The loss at a frequency between antennas of two heights.
     *
     * @param baseMetres height of the tower's antenna
     * @param mobileMetres height of the mobile's antenna
     */
    public PathLoss(double megahertz, double baseMetres, double mobileMetres, Clutter surroundings) {
        double logFrequency = Math.log10(megahertz);
        double logBase = Math.log10(baseMetres);
        double constants = megahertz < COST_231_FROM_MEGAHERTZ
                ? 69.55 + 26.16 * logFrequency
                : 46.3 + 33.9 * logFrequency + (surroundings == Clutter.METROPOLITAN ? 3 : 0);
        double mobileCorrection = (1.1 * logFrequency - 0.7) * mobileMetres - (1.56 * logFrequency - 0.8);
        atOneKilometerDecibels = constants - 13.82 * logBase - mobileCorrection - relief(logFrequency, surroundings);
        perDecadeDecibels = 44.9 - 6.55 * logBase;
        // 20 log(4 pi d f / c) with d in km and f in MHz
        freeSpaceDecibels = 32.45 + 20 * logFrequency;
    }

    /** Reduction of the loss outside towns. */
    private static double relief(double logFrequency, Clutter surroundings) {
        return switch (surroundings) {
            case METROPOLITAN, URBAN -> 0;
            case SUBURBAN -> 2 * Math.pow(logFrequency - Math.log10(28), 2) + 5.4;
            case OPEN -> 4.78 * logFrequency * logFrequency - 18.33 * logFrequency + 40.94;
        };
    }

    /** The loss at a distance in dB, a positive number. */
    public double decibels(double metres) {
        double logKilometres = Math.log10(Math.max(NEAREST_METRES, metres) / 1_000);
        return Math.max(
                atOneKilometerDecibels + perDecadeDecibels * logKilometres, freeSpaceDecibels + 20 * logKilometres);
    }
}
