package simgsm.center.journal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/**
 * Seeds of {@link Simulation}. A broken invariant names its seed; {@code -Dsimulation.first=SEED -Dsimulation.seeds=1} runs
 * it again, a large number of seeds searches for more.
 */
class SimulationTest {
    private static final long FIRST = Long.getLong("simulation.first", 1);
    private static final long SEEDS = Long.getLong("simulation.seeds", 100);
    private static final long REPORTED_SEEDS = 5_000;

    @Test
    void noInvariantBreaksWhateverHappens() throws IOException {
        long acknowledged = 0;
        long deaths = 0;
        long calls = 0;
        for (long seed = FIRST; seed < FIRST + SEEDS; seed++) {
            Simulation simulation = new Simulation(seed);
            try {
                simulation.run();
            } catch (AssertionError | RuntimeException broken) {
                throw new AssertionError("seed " + seed + ": " + broken.getMessage(), broken);
            }
            acknowledged += simulation.acknowledgedCount();
            deaths += simulation.deaths();
            calls += simulation.callsSetUp();
            long done = seed - FIRST + 1;
            if (done == SEEDS || done % REPORTED_SEEDS == 0) {
                System.out.println(done + " seeds, " + acknowledged + " messages acknowledged, " + calls + " calls, "
                        + deaths + " deaths");
            }
        }
        assertTrue(acknowledged > 10 * SEEDS || SEEDS < 10, acknowledged + " messages were acknowledged");
        assertTrue(deaths > SEEDS || SEEDS < 10, deaths + " deaths");
        assertTrue(calls > 0 || SEEDS < 10, calls + " calls");
    }

    @Test
    void aSeedReplays() throws IOException {
        for (long seed = FIRST; seed < FIRST + Math.min(SEEDS, 3); seed++) {
            Simulation first = new Simulation(seed);
            first.run();
            Simulation second = new Simulation(seed);
            second.run();
            assertEquals(first.trace(), second.trace(), "seed " + seed);
        }
    }
}
