package simgsm.cells.radio;

import java.util.List;
import simgsm.cells.town.Building;
import simgsm.cells.town.Frequencies;
import simgsm.cells.town.Hill;
import simgsm.cells.town.Tower;
import simgsm.cells.town.Town;

/**
 * The loss between each tower of a town and each place: distance, shadowing, hills, and the building around the place.
 * The loss is the same in both directions. A pure function of town and seed; callable on any thread.
 */
public final class Propagation {
    /** Height of a mobile's antenna above the ground. */
    public static final double MOBILE_METRES = 1.5;

    private final Town town;
    private final List<Tower> towers;
    private final PathLoss[] losses;
    private final ShadowField[] shadows;
    private final double[] megahertz;
    private final double[] antennaMetres;

    /** @param seed of the shadowing */
    public Propagation(Town town, long seed) {
        this(town, town.shadowDecibels(), seed);
    }

    /** The town's median losses, without shadowing. */
    public Propagation median() {
        return new Propagation(town, 0, 0);
    }

    private Propagation(Town town, double shadowDecibels, long seed) {
        this.town = town;
        towers = town.towers();
        losses = new PathLoss[towers.size()];
        shadows = new ShadowField[towers.size()];
        megahertz = new double[towers.size()];
        antennaMetres = new double[towers.size()];
        for (int i = 0; i < losses.length; i++) {
            Tower tower = towers.get(i);
            megahertz[i] = Frequencies.downlinkMegahertz(tower.arfcn());
            losses[i] = new PathLoss(megahertz[i], tower.heightMetres(), MOBILE_METRES, town.surroundings());
            shadows[i] = new ShadowField(
                    shadowDecibels,
                    town.shadowMetres(),
                    seed * 1_000_003 + tower.name().hashCode());
            antennaMetres[i] = tower.heightMetres()
                    + groundMetres(tower.place().xMetres(), tower.place().yMetres());
        }
    }

    public Town town() {
        return town;
    }

    private double groundMetres(double x, double y) {
        double height = 0;
        for (Hill hill : town.hills()) {
            height = Math.max(height, hill.heightMetres(x, y));
        }
        return height;
    }

    /** The distance between a tower's foot and a place in metres. */
    public double distanceMetres(int tower, double x, double y) {
        double dx = x - towers.get(tower).place().xMetres();
        double dy = y - towers.get(tower).place().yMetres();
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** The loss between a tower, by its index in the town, and a place in dB. */
    public double lossDecibels(int tower, double x, double y) {
        return outdoorLossDecibels(tower, x, y) + buildingLossDecibels(x, y);
    }

    /** The losses of all towers at one place. @param into one value a tower */
    public void lossesDecibels(double x, double y, double[] into) {
        double building = buildingLossDecibels(x, y);
        for (int i = 0; i < losses.length; i++) {
            into[i] = outdoorLossDecibels(i, x, y) + building;
        }
    }

    private double outdoorLossDecibels(int tower, double x, double y) {
        double loss = losses[tower].decibels(distanceMetres(tower, x, y)) + shadows[tower].decibels(x, y);
        if (!town.hills().isEmpty()) {
            double mobile = groundMetres(x, y) + MOBILE_METRES;
            for (Hill hill : town.hills()) {
                loss += KnifeEdge.decibels(
                        hill, towers.get(tower).place(), antennaMetres[tower], x, y, mobile, megahertz[tower]);
            }
        }
        return loss;
    }

    /** The loss by buildings at a place in dB; 0 outside. */
    public double buildingLossDecibels(double x, double y) {
        double loss = 0;
        for (Building building : town.buildings()) {
            if (building.contains(x, y)) {
                loss = Math.max(loss, building.lossDecibels());
            }
        }
        return loss;
    }
}
