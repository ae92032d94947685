package simgsm.cells.town;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The content of a {@code .town} file.
 *
 * @param name the window's title
 * @param westMetres x of its western edge
 * @param southMetres y of its southern edge
 * @param widthMetres from west to east
 * @param heightMetres from south to north
 * @param shadowDecibels standard deviation of the shadowing; 0 for none
 * @param shadowMetres distance at which its correlation has fallen to 1/e
 * @param radioLinkTimeout SACCH blocks, 4 to 64 in steps of 4 (RADIO_LINK_TIMEOUT)
 * @param starts initial places of mobiles, by number
 */
public record Town(
        String name,
        double westMetres,
        double southMetres,
        double widthMetres,
        double heightMetres,
        Clutter surroundings,
        double shadowDecibels,
        double shadowMetres,
        int radioLinkTimeout,
        List<Tower> towers,
        List<Building> buildings,
        List<Hill> hills,
        List<Walk> walks,
        Map<String, TownPlace> starts) {
    private static final double SIDE_METRES = 20_000;
    private static final int STANDARD_RADIO_LINK_TIMEOUT = 16;

    public Town {
        towers = List.copyOf(towers);
        buildings = List.copyOf(buildings);
        hills = List.copyOf(hills);
        walks = List.copyOf(walks);
        starts = Map.copyOf(starts);
    }

    /** A town of towers alone, without shadowing, with a radio link time-out of 16 blocks. */
    public Town(List<Tower> towers) {
        this(
                "",
                -SIDE_METRES / 2,
                -SIDE_METRES / 2,
                SIDE_METRES,
                SIDE_METRES,
                Clutter.URBAN,
                0,
                1,
                STANDARD_RADIO_LINK_TIMEOUT,
                towers,
                List.of(),
                List.of(),
                List.of(),
                Map.of());
    }

    /** A mobile's initial place: its line, the begin of its walk, or the town's middle. */
    public TownPlace start(String number) {
        TownPlace own = starts.get(number);
        return own != null
                ? own
                : walkOf(number)
                        .map(walk -> walk.points().get(0))
                        .orElse(new TownPlace(westMetres + widthMetres / 2, southMetres + heightMetres / 2));
    }

    /** A mobile's initial walk. */
    public Optional<Walk> walkOf(String number) {
        return walks.stream().filter(walk -> walk.number().equals(number)).findFirst();
    }

    public Optional<Walk> walk(String walkName) {
        return walks.stream().filter(walk -> walk.name().equals(walkName)).findFirst();
    }

    public Optional<Tower> tower(String towerName) {
        return towers.stream().filter(tower -> tower.name().equals(towerName)).findFirst();
    }

    /** The nearest place within the town. */
    public TownPlace within(double xMetres, double yMetres) {
        return new TownPlace(
                Math.max(westMetres, Math.min(westMetres + widthMetres, xMetres)),
                Math.max(southMetres, Math.min(southMetres + heightMetres, yMetres)));
    }
}
