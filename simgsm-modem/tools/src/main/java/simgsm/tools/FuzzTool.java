package simgsm.tools;

import java.io.PrintStream;
import java.net.InetSocketAddress;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.HostPort;
import simgsm.console.UnavailableException;
import simgsm.tools.fuzz.CenterFuzz;
import simgsm.tools.fuzz.CodecFuzz;
import simgsm.tools.fuzz.FuzzFailure;

/** {@code fuzz}: mutated frames for the decoders, or for a running centre. */
final class FuzzTool {
    private static final long MOST_FRAMES = 100_000_000_000L;
    /** One tenth of the frames precede the first measurement of the heap, so that all classes are loaded. */
    private static final int WARM_UP_SHARE = 10;

    private static final int OCTETS_PER_KIB = 1024;

    private FuzzTool() {}

    static int run(Arguments arguments, PrintStream out, PrintStream err) throws Exception {
        long frames = arguments.integer("frames", 1_000_000, 1, MOST_FRAMES);
        long seed = arguments.integer("seed", new Random().nextInt(Integer.MAX_VALUE), Long.MIN_VALUE, Long.MAX_VALUE);
        Optional<HostPort> center = arguments.hostPort("center");
        try {
            Event result = center.isPresent() ? overTcp(center.get(), frames, seed) : codec(frames, seed);
            out.print(result + "\n");
            out.flush();
            return ExitStatus.OK;
        } catch (FuzzFailure failure) {
            err.println("simgsm-modem: fuzz --seed " + seed + ": " + failure.getMessage());
            return ExitStatus.FAILED;
        }
    }

    private static Event codec(long frames, long seed) {
        CodecFuzz fuzz = new CodecFuzz(seed);
        long began = System.nanoTime();
        long warm = Math.max(1, frames / WARM_UP_SHARE);
        while (fuzz.frames() < warm) {
            fuzz.step();
        }
        long heapBefore = usedHeap();
        while (fuzz.frames() < frames) {
            fuzz.step();
        }
        return Event.of("fuzz")
                .with("seed", seed)
                .with("frames", fuzz.frames())
                .with("read", fuzz.read())
                .with("refused", fuzz.refused())
                .with("seconds", seconds(began))
                .with("growthkib", Math.max(0, usedHeap() - heapBefore) / OCTETS_PER_KIB);
    }

    private static Event overTcp(HostPort center, long frames, long seed) throws UnavailableException {
        LoadTool.requireCenter(center);
        CenterFuzz fuzz = new CenterFuzz(new InetSocketAddress(center.host(), center.port()), seed);
        long began = System.nanoTime();
        fuzz.run(frames);
        return Event.of("fuzz")
                .with("seed", seed)
                .with("frames", fuzz.frames())
                .with("connections", fuzz.connections())
                .with("seconds", seconds(began));
    }

    private static String seconds(long beganNanos) {
        return String.format(Locale.ROOT, "%.1f", (System.nanoTime() - beganNanos) / 1e9);
    }

    /** Octets in use after a garbage collection. */
    private static long usedHeap() {
        System.gc();
        return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
    }
}
