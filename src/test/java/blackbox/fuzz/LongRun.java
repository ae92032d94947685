package blackbox.fuzz;

import java.util.stream.LongStream;

/** The size of a run: {@code -Dfuzz.frames=N -Dfuzz.first=SEED -Dfuzz.seeds=N}. */
final class LongRun {
    private LongRun() {}

    /** Frames per seed. */
    static long frames(long standard) {
        return Long.getLong("fuzz.frames", standard);
    }

    static LongStream seeds() {
        long first = Long.getLong("fuzz.first", 1);
        return LongStream.range(first, first + Long.getLong("fuzz.seeds", 3));
    }
}
