package simgsm.net;

import java.io.IOException;
import java.nio.channels.WritableByteChannel;

/** A connection with an {@link OutputQueue} of messages not yet taken by the peer. */
public abstract class QueuedConnection extends Connection {
    private final OutputQueue output;

    protected QueuedConnection(Endpoint endpoint, OutputQueue output) {
        super(endpoint);
        this.output = output;
    }

    /**
     * Queues a message. It is written at once if none waits before it; a droppable one at the end of the loop's
     * running action, together with others of that action.
     *
     * @return false if too many messages wait: the peer does not read
     */
    protected final boolean write(byte[] message, boolean isDroppable) {
        makeRoom(isDroppable);
        boolean isFirst = output.isEmpty();
        boolean hasRoom = output.add(message, isDroppable);
        if (isFirst && isDroppable) {
            flushAfterAction();
        } else if (isFirst && hasRoom) {
            flush();
        }
        return hasRoom;
    }

    /** Queues a message for the end of the iteration; otherwise as {@link #write}. */
    protected final boolean writeLater(byte[] message, boolean isDroppable) {
        makeRoom(isDroppable);
        flushLater();
        return output.add(message, isDroppable);
    }

    /** Flushes before a message is dropped: the socket may take waiting ones now. */
    private void makeRoom(boolean isDroppable) {
        if (isDroppable && output.dropsNext()) {
            flush();
        }
    }

    /** Messages not yet taken by the peer. */
    protected final OutputQueue output() {
        return output;
    }

    @Override
    public final boolean hasOutput() {
        return !output.isEmpty();
    }

    @Override
    protected void writeTo(WritableByteChannel channel) throws IOException {
        output.flush(channel);
    }
}
