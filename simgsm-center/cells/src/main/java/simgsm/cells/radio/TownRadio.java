package simgsm.cells.radio;

import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import simgsm.cells.town.Tower;
import simgsm.cells.town.Town;
import simgsm.cells.town.TownPlace;

/** The radio channels of a town, by {@link Propagation} and {@link ReceptionQuality}. */
public final class TownRadio implements Radio {
    private final Propagation propagation;
    private final Map<Tower, Integer> indices = new IdentityHashMap<>();
    private final Map<String, Integer> indicesByName = new HashMap<>();

    /** @param seed of the shadowing */
    public TownRadio(Town town, long seed) {
        propagation = new Propagation(town, seed);
        List<Tower> towers = town.towers();
        for (int i = 0; i < towers.size(); i++) {
            indices.put(towers.get(i), i);
            indicesByName.put(towers.get(i).name(), i);
        }
    }

    public Propagation propagation() {
        return propagation;
    }

    @Override
    public double levelDbm(Tower tower, TownPlace place) {
        Integer index = indices.get(tower);
        if (index == null) {
            // the same tower with another power
            index = indicesByName.get(tower.name());
        }
        return tower.powerDbm() - propagation.lossDecibels(index, place.xMetres(), place.yMetres());
    }

    @Override
    public double bitErrorRate(double levelDbm, double interfererDbm) {
        return ReceptionQuality.bitErrorRate(
                ReceptionQuality.carrierDecibels(levelDbm, ReceptionQuality.milliwatts(interfererDbm)));
    }
}
