package simrobot.world;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** The grid of discs against a list that is looked through from end to end. */
class DiscGridTest {
    private final DiscGrid grid = new DiscGrid();
    private final Map<Integer, double[]> all = new TreeMap<>();
    private final Random chance = new Random(11);

    private void put(int disc, double x, double y) {
        grid.put(disc, x, y);
        all.put(disc, new double[] {x, y});
    }

    private Set<Integer> near(double x1, double y1, double x2, double y2) {
        Set<Integer> found = new TreeSet<>();
        int count = grid.near(x1, y1, x2, y2);
        for (int i = 0; i < count; i++) {
            found.add(grid.found(i));
        }
        assertEquals(count, found.size(), "each once");
        return found;
    }

    private Set<Integer> nearOneByOne(double x1, double y1, double x2, double y2) {
        Set<Integer> found = new TreeSet<>();
        all.forEach((disc, at) -> {
            if (at[0] >= x1 && at[0] <= x2 && at[1] >= y1 && at[1] <= y2) {
                found.add(disc);
            }
        });
        return found;
    }

    @Test
    void itFindsWhatAListFindsWhileDiscsComeMoveAndGo() {
        for (int round = 0; round < 20_000; round++) {
            int disc = chance.nextInt(300);
            if (chance.nextInt(5) == 0) {
                grid.remove(disc);
                all.remove(disc);
            } else {
                double spread = round % 7 == 0 ? 5_000 : 30;
                put(disc, chance.nextGaussian() * spread, chance.nextGaussian() * spread);
            }
            double x = chance.nextGaussian() * 30;
            double y = chance.nextGaussian() * 30;
            double width = chance.nextInt(50) == 0 ? 20_000 : chance.nextDouble() * 12;
            assertEquals(
                    nearOneByOne(x, y, x + width, y + width / 2),
                    near(x, y, x + width, y + width / 2),
                    "round " + round);
        }
    }

    @Test
    void aRobotIsCrowdedWithAnotherNearerThanTheDistance() {
        put(0, 1, 1);
        put(1, 1.6, 1);
        assertEquals(true, grid.isCrowded(-1, 1.2, 1, 0.5));
        assertEquals(false, grid.isCrowded(0, 1, 1, 0.5));
        assertEquals(true, grid.isCrowded(0, 1.2, 1, 0.5));
        assertEquals(false, grid.isCrowded(-1, 3, 1, 0.5));
    }

    @Test
    void aThousandKilometersApartOnATorusTheyAreStillNotNeighbours() {
        put(0, 1e6, -1e6);
        put(1, 1e6 + 4 * 8, -1e6);
        assertEquals(Set.of(0), near(1e6 - 1, -1e6 - 1, 1e6 + 1, -1e6 + 1));
    }
}
