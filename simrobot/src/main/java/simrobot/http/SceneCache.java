package simrobot.http;

import simrobot.simulation.SimulationSnapshot;

/** The newest scene, requested from the simulation at most 20 times a second. */
final class SceneCache {
    private static final long FRESH_NANOS = 50_000_000;

    private final WebSource source;
    private SimulationSnapshot newest;
    private long takenNanos;

    SceneCache(WebSource source) {
        this.source = source;
    }

    /** The scene, at most 50 ms old. */
    synchronized SimulationSnapshot now() throws InterruptedException {
        long now = System.nanoTime();
        if (newest == null || now - takenNanos > FRESH_NANOS) {
            newest = source.scene();
            takenNanos = now;
        }
        return newest;
    }
}
