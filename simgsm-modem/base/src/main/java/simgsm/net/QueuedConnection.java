package simgsm.net;

import java.io.IOException;
import java.nio.channels.WritableByteChannel;

/** A connection whose messages wait in an {@link OutputQueue} until the peer takes them. */
public abstract class QueuedConnection extends Connection {
    private final OutputQueue output;

    protected QueuedConnection(Endpoint endpoint, OutputQueue output) {
        super(endpoint);
        this.output = output;
    }

    /**
     * Queues a message, and writes it at once if none waits before it.
     *
     * @return false if more than the permitted number of messages wait: the peer does not read
     */
    protected final boolean write(byte[] message, boolean isDroppable) {
        boolean isFirst = output.isEmpty();
        boolean hasRoom = output.add(message, isDroppable);
        if (hasRoom && isFirst) {
            flush();
        }
        return hasRoom;
    }

    /** Queues a message, which leaves at the end of the iteration; otherwise as {@link #write}. */
    protected final boolean writeLater(byte[] message) {
        flushLater();
        return output.add(message, false);
    }

    /** Messages that the peer has not yet taken. */
    protected final OutputQueue output() {
        return output;
    }

    @Override
    public final boolean hasOutput() {
        return !output.isEmpty();
    }

    @Override
    protected final void writeTo(WritableByteChannel channel) throws IOException {
        output.flush(channel);
    }
}
