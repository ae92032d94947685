package simgsm.tools.fuzz;

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
 * Spoilt dialogues against a running centre, over TCP. The stations' time runs a hundred times as fast as the centre's, so
 * that they do not wait long for what was lost. Every few thousand frames a connection of good manners must still be
 * answered.
 */
public final class CenterFuzz {
    private static final int PEERS = 16;
    private static final long FIRST_NUMBER = 7_900_000;
    private static final int HASTE = 100;
    private static final int FRAMES_BETWEEN_CHECKS = 5_000;
    private static final int PATIENCE_MILLIS = 10_000;
    private static final int BUFFER_LENGTH = 65_536;

    private final InetSocketAddress center;
    private final List<FuzzSocket> sockets = new ArrayList<>();
    private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER_LENGTH);
    private final long startNanos = System.nanoTime();
    private long checkAtFrames = FRAMES_BETWEEN_CHECKS;

    public CenterFuzz(InetSocketAddress center, long seed) {
        this.center = center;
        SplittableRandom random = new SplittableRandom(seed);
        List<Msisdn> numbers = new ArrayList<>();
        for (int i = 0; i < PEERS; i++) {
            numbers.add(new Msisdn(String.valueOf(FIRST_NUMBER + i)));
        }
        numbers.forEach(number -> sockets.add(new FuzzSocket(new FuzzPeer(number, numbers, random.split()))));
    }

    /** Frames, spoilt or not, that went to the centre. */
    public long frames() {
        return sockets.stream().mapToLong(FuzzSocket::frames).sum();
    }

    /** Connections that were made, since spoilt ones are given up by either side. */
    public long connections() {
        return sockets.stream().mapToLong(FuzzSocket::connections).sum();
    }

    /**
     * Goes on until so many frames have been sent.
     *
     * @throws Finding if the centre does not answer any more
     */
    public void run(long mostFrames) {
        try {
            while (frames() < mostFrames) {
                for (FuzzSocket socket : sockets) {
                    socket.turn(center, buffer, (System.nanoTime() - startNanos) * HASTE);
                }
                if (frames() >= checkAtFrames) {
                    check();
                }
            }
            check();
        } finally {
            sockets.forEach(FuzzSocket::close);
        }
    }

    /** A centre that lives asks whoever connects for its identity. */
    private void check() {
        checkAtFrames = frames() + FRAMES_BETWEEN_CHECKS;
        long began = System.nanoTime();
        try (SocketChannel channel = SocketChannel.open()) {
            channel.socket().connect(center, PATIENCE_MILLIS);
            channel.socket().setSoTimeout(PATIENCE_MILLIS);
            if (channel.socket().getInputStream().read() < 0) {
                throw new IOException("it closes connections at once");
            }
        } catch (IOException e) {
            long waited = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - began);
            throw new Finding(
                    "after " + frames() + " frames the centre does not answer within " + waited + " ms: "
                            + e.getMessage(),
                    e);
        }
    }
}
