package simgsm.net;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.util.concurrent.TimeUnit;

/**
 * A connection whose output of one iteration is sent in one write. While the peer does not read, nothing is read from it;
 * a peer that leaves more than a limit unread is disconnected.
 */
public abstract class BufferedConnection extends Connection {
    private static final int INITIAL_CAPACITY = 4 * 1024;
    private static final int KEPT_CAPACITY = 64 * 1024;
    private static final long LINGER_NANOS = TimeUnit.SECONDS.toNanos(10);

    private final int enoughUnsent;
    private final int tooMuchUnsent;
    private ByteBuffer unsent = ByteBuffer.allocate(INITIAL_CAPACITY);
    private boolean isEnding;

    /**
     * @param enoughUnsent octets from which nothing is read
     * @param tooMuchUnsent octets above which the peer is disconnected
     */
    protected BufferedConnection(Endpoint endpoint, int enoughUnsent, int tooMuchUnsent) {
        super(endpoint);
        this.enoughUnsent = enoughUnsent;
        this.tooMuchUnsent = tooMuchUnsent;
    }

    /** Sends octets at the end of the iteration. */
    public void send(byte[] octets) {
        if (!isOpen()) {
            return;
        }
        if (unsent.remaining() < octets.length) {
            int needed = unsent.position() + octets.length;
            unsent =
                    ByteBuffer.allocate(Math.max(needed, 2 * unsent.capacity())).put(unsent.flip());
        }
        unsent.put(octets);
        if (unsent.position() > tooMuchUnsent) {
            fail(unsent.position() + " octets not taken");
        }
        flushLater();
    }

    /** Reads nothing more, and ends the connection once all octets are written, after 10 s at the latest. */
    public void closeWhenSent() {
        isEnding = true;
        flushLater();
        after(LINGER_NANOS, () -> fail("does not read"));
    }

    /** True after {@link #closeWhenSent}. */
    protected final boolean isEnding() {
        return isEnding;
    }

    @Override
    protected final void writeTo(WritableByteChannel channel) throws IOException {
        unsent.flip();
        channel.write(unsent);
        unsent.compact();
        if (!hasOutput() && unsent.capacity() > KEPT_CAPACITY) {
            unsent = ByteBuffer.allocate(INITIAL_CAPACITY);
        }
        if (!hasOutput() && isEnding) {
            fail("ended");
        }
    }

    @Override
    protected final boolean wantsInput() {
        return unsent.position() < enoughUnsent && !isEnding;
    }

    @Override
    protected final boolean hasOutput() {
        return unsent.position() > 0;
    }
}
