package blackbox.fuzz;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import simgsm.air.Msisdn;

/**
 * Mutated dialogues with a running centre over TCP. The stations' time runs 100 times as fast as the centre's, so that
 * their timers of lost messages expire soon. Every 5000 frames an intact connection must be answered.
 */
final class CenterFuzz {
    private static final int PEERS = 16;
    private static final long FIRST_NUMBER = 7_900_000;
    private static final int TIME_FACTOR = 100;
    private static final int FRAMES_BETWEEN_CHECKS = 5_000;
    private static final int TIMEOUT_MILLIS = 10_000;
    private static final int BUFFER_LENGTH = 65_536;

    private final InetSocketAddress center;
    private final List<FuzzConnection> sockets = new ArrayList<>();
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER_LENGTH);
    private final long startNanos = System.nanoTime();
    private long checkAtFrames = FRAMES_BETWEEN_CHECKS;

    CenterFuzz(InetSocketAddress center, long seed) {
        this.center = center;
        SplittableRandom random = new SplittableRandom(seed);
        List<Msisdn> numbers = new ArrayList<>();
        for (int i = 0; i < PEERS; i++) {
            numbers.add(new Msisdn(String.valueOf(FIRST_NUMBER + i)));
        }
        numbers.forEach(number -> sockets.add(new FuzzConnection(new FuzzStation(number, numbers, random.split()))));
    }

    /** Frames sent to the centre, mutated or not. */
    long frames() {
        return sockets.stream().mapToLong(FuzzConnection::frames).sum();
    }

    /**
     * Runs until this number of frames is sent.
     *
     * @throws AssertionError if the centre stops answering
     */
    void run(long mostFrames) {
        try {
            while (frames() < mostFrames) {
                for (FuzzConnection socket : sockets) {
                    socket.turn(center, buffer, (System.nanoTime() - startNanos) * TIME_FACTOR);
                }
                if (frames() >= checkAtFrames) {
                    check();
                }
            }
            check();
        } finally {
            sockets.forEach(FuzzConnection::close);
        }
    }

    /** A working centre asks each new connection for its identity. */
    private void check() {
        checkAtFrames = frames() + FRAMES_BETWEEN_CHECKS;
        long began = System.nanoTime();
        try (SocketChannel channel = SocketChannel.open()) {
            channel.socket().connect(center, TIMEOUT_MILLIS);
            channel.socket().setSoTimeout(TIMEOUT_MILLIS);
            if (channel.socket().getInputStream().read() < 0) {
                throw new IOException("it closes connections at once");
            }
        } catch (IOException e) {
            long waited = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - began);
            throw new AssertionError(
                    "after " + frames() + " frames the centre does not answer within " + waited + " ms: "
                            + e.getMessage(),
                    e);
        }
    }
}
