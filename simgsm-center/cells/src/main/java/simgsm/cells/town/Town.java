package simgsm.cells.town;

import java.util.List;
import java.util.Optional;

/** What a town file holds. Immutable. */
public record Town(List<Tower> towers) {
    public Town {
        towers = List.copyOf(towers);
    }

    public Optional<Tower> tower(String name) {
        return towers.stream().filter(tower -> tower.name().equals(name)).findFirst();
    }
}
