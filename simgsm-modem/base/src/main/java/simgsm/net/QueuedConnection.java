package simgsm.net;

import java.io.IOException;
import java.nio.channels.WritableByteChannel;

/** A connection with an {@link OutputQueue}: messages wait in it until the peer takes them. */
public abstract class QueuedConnection extends Connection {
    private final OutputQueue output;

    protected QueuedConnection(Endpoint endpoint, OutputQueue output) {
        super(endpoint);
        this.output = output;
    }

    /**
     * Queues a message. If none waits before it, it is written at once; a droppable one at the end of the loop's present
     * action, so that those of one action share a write.
     *
     * @return false if more than the permitted number of messages wait: the peer does not read
     */
    protected final boolean write(byte[] message, boolean isDroppable) {
        if (isDroppable && output.dropsNext()) {
            flush();
        }
        boolean isFirst = output.isEmpty();
        boolean hasRoom = output.add(message, isDroppable);
        if (isFirst && isDroppable) {
            flushAfterAction();
        } else if (isFirst && hasRoom) {
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
