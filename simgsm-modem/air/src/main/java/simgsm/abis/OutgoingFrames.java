package simgsm.abis;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.util.ArrayDeque;
import java.util.Iterator;
import java.util.function.Consumer;

/**
 * Frames of one connection that are not sent yet, on either side. While the peer keeps up, each frame is a write of its
 * own, so that a capture shows one message per segment. When it does not, signalling waits in order, and the newest
 * speech frame replaces the oldest.
 */
public final class OutgoingFrames {
    /** 200 ms of speech, 20 ms a frame. */
    static final int MOST_SPEECH_FRAMES = 10;

    private final int mostSignallingFrames;
    private final Consumer<byte[]> written;

    private record QueuedFrame(ByteBuffer octets, boolean isSpeech) {}

    private final ArrayDeque<QueuedFrame> queue = new ArrayDeque<>();
    private int speechFrames;
    private long droppedSpeechFrames;

    /** @param mostSignallingFrames signalling frames that may wait */
    public OutgoingFrames(int mostSignallingFrames) {
        this(mostSignallingFrames, wire -> {});
    }

    /** @param written receives the octets of each frame after its last octet is written */
    public OutgoingFrames(int mostSignallingFrames, Consumer<byte[]> written) {
        this.mostSignallingFrames = mostSignallingFrames;
        this.written = written;
    }

    /**
     * Sends or queues a frame.
     *
     * @return false when more signalling waits than is allowed: the link should be closed
     */
    public boolean send(IpaFrame frame, WritableByteChannel channel) throws IOException {
        ByteBuffer octets = ByteBuffer.wrap(IpaFramer.encode(frame));
        if (queue.isEmpty()) {
            channel.write(octets);
            if (!octets.hasRemaining()) {
                written.accept(octets.array());
                return true;
            }
        }
        boolean isSpeech = frame.stream() == IpaFrame.SPEECH;
        if (isSpeech && speechFrames == MOST_SPEECH_FRAMES) {
            dropOldestSpeech();
        }
        speechFrames += isSpeech ? 1 : 0;
        queue.addLast(new QueuedFrame(octets, isSpeech));
        return queue.size() - speechFrames <= mostSignallingFrames;
    }

    /** Writes until the channel accepts no more or the queue is empty. */
    public void flush(WritableByteChannel channel) throws IOException {
        while (!queue.isEmpty()) {
            QueuedFrame first = queue.peekFirst();
            channel.write(first.octets);
            if (first.octets.hasRemaining()) {
                return;
            }
            queue.removeFirst();
            speechFrames -= first.isSpeech ? 1 : 0;
            written.accept(first.octets.array());
        }
    }

    public boolean isEmpty() {
        return queue.isEmpty();
    }

    public int size() {
        return queue.size();
    }

    public long droppedSpeechFrames() {
        return droppedSpeechFrames;
    }

    /** Empties the queue after the end of the connection. */
    public void clear() {
        queue.clear();
        speechFrames = 0;
    }

    /** A frame that is written in part stays, or the peer would lose the framing. */
    private void dropOldestSpeech() {
        for (Iterator<QueuedFrame> each = queue.iterator(); each.hasNext(); ) {
            QueuedFrame candidate = each.next();
            if (candidate.isSpeech && candidate.octets.position() == 0) {
                each.remove();
                speechFrames--;
                droppedSpeechFrames++;
                return;
            }
        }
    }
}
