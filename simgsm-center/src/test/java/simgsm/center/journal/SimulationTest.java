package simgsm.center.journal;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/**
 * Seeds of {@link Simulation}. A broken invariant names its seed; {@code -Dsimulation.first=SEED -Dsimulation.seeds=1} runs
 * it again, a large number of seeds searches for more.
 */
class SimulationTest {
    private static final long FIRST = Long.getLong("simulation.first", 1);
    private static final long SEEDS = Long.getLong("simulation.seeds", 150);

    @Test
    void noInvariantBreaksWhateverHappens() throws IOException {
        long acknowledged = 0;
        long deaths = 0;
        for (long seed = FIRST; seed < FIRST + SEEDS; seed++) {
            Simulation simulation = new Simulation(seed);
            try {
                simulation.run();
            } catch (AssertionError | RuntimeException broken) {
                throw new AssertionError("seed " + seed + ": " + broken.getMessage(), broken);
            }
            acknowledged += simulation.acknowledgedCount();
            deaths += simulation.deaths;
        }
        assertTrue(acknowledged > SEEDS, acknowledged + " messages were acknowledged");
        assertTrue(deaths > 0 || SEEDS < 10, deaths + " deaths");
        System.out.println(SEEDS + " seeds, " + acknowledged + " messages acknowledged, " + deaths + " deaths");
    }
}
