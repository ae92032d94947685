package simgsm.cells.town;

/**
 * A building or a tunnel: a rectangle that attenuates reception inside.
 *
 * @param lossDecibels from its wall inwards
 */
public record Building(
        String name,
        double westMetres,
        double southMetres,
        double eastMetres,
        double northMetres,
        double lossDecibels) {

    public boolean contains(double xMetres, double yMetres) {
        return xMetres >= westMetres && xMetres <= eastMetres && yMetres >= southMetres && yMetres <= northMetres;
    }
}
