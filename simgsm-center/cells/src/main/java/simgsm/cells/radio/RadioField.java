package simgsm.cells.radio;

import java.util.List;
import java.util.stream.IntStream;
import simgsm.cells.town.Tower;

/**
 * The levels of all towers at a place, with the towers' current power. Not thread-safe: arrays are reused, so that 1
 * 000 mobiles among 50 towers create no garbage.
 */
public final class RadioField {
    /** The level of a tower that is off. */
    public static final double SILENCE_DBM = -200;

    private final Propagation propagation;
    private final TowerState[] towers;
    /** Indices of the other towers on the same channel, and on the adjacent channels. */
    private final int[][] sameChannel;

    private final int[][] adjacentChannel;

    public RadioField(Propagation propagation) {
        this.propagation = propagation;
        List<Tower> all = propagation.town().towers();
        towers = new TowerState[all.size()];
        sameChannel = new int[all.size()][];
        adjacentChannel = new int[all.size()][];
        for (int i = 0; i < towers.length; i++) {
            towers[i] = new TowerState(true, all.get(i).powerDbm());
            sameChannel[i] = others(all, i, 0);
            adjacentChannel[i] = others(all, i, 1);
        }
    }

    private static int[] others(List<Tower> all, int of, int channelsAway) {
        return IntStream.range(0, all.size())
                .filter(i ->
                        i != of && Math.abs(all.get(i).arfcn() - all.get(of).arfcn()) == channelsAway)
                .toArray();
    }

    public TowerState tower(int index) {
        return towers[index];
    }

    public void set(int tower, TowerState state) {
        towers[tower] = state;
    }

    /** The levels at a place in dBm. @param into one value a tower, in the order of the town */
    public void levelsDbm(double xMetres, double yMetres, double[] into) {
        propagation.lossesDecibels(xMetres, yMetres, into);
        for (int i = 0; i < towers.length; i++) {
            into[i] = towers[i].isOn() ? towers[i].powerDbm() - into[i] : SILENCE_DBM;
        }
    }

    /**
     * The carrier of one tower over noise and over all others on its channel and the adjacent ones, in dB.
     *
     * @param levelsDbm of all towers at the place
     */
    public double carrierDecibels(int tower, double[] levelsDbm) {
        double interference = 0;
        for (int other : sameChannel[tower]) {
            interference += ReceptionQuality.milliwatts(levelsDbm[other]);
        }
        for (int other : adjacentChannel[tower]) {
            interference += ReceptionQuality.milliwatts(levelsDbm[other] - ReceptionQuality.ADJACENT_DECIBELS);
        }
        return ReceptionQuality.carrierDecibels(levelsDbm[tower], interference);
    }
}
