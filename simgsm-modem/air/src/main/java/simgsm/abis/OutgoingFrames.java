package simgsm.abis;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.util.ArrayDeque;
import java.util.Iterator;
import java.util.function.Consumer;

/**
 * What the other end of a connection has not yet taken, for stations and for their centre. While it keeps up, each frame goes out at once in a write of its own, so that observers
 * see one message a segment. When it does not, signalling waits in order and the oldest speech makes room for the newest.
 */
public final class OutgoingFrames {
    /** 200 ms of speech at 20 ms a frame. */
    static final int MOST_SPEECH_FRAMES = 10;

    private final int mostSignallingFrames;
    private final Consumer<byte[]> written;

    private record Waiting(ByteBuffer octets, boolean isSpeech) {}

    private final ArrayDeque<Waiting> queue = new ArrayDeque<>();
    private int speechFrames;
    private long droppedSpeechFrames;

    /** @param mostSignallingFrames a peer that has not taken so many is not reading any more */
    public OutgoingFrames(int mostSignallingFrames) {
        this(mostSignallingFrames, wire -> {});
    }

    /** @param written told of each frame, as it is on the wire, once it has left whole */
    public OutgoingFrames(int mostSignallingFrames, Consumer<byte[]> written) {
        this.mostSignallingFrames = mostSignallingFrames;
        this.written = written;
    }

    /**
     * Sends or queues a frame.
     *
     * @return false when the peer is so far behind that the link is not worth keeping
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
        queue.addLast(new Waiting(octets, isSpeech));
        return queue.size() - speechFrames <= mostSignallingFrames;
    }

    /** Writes until the peer takes no more or nothing waits. */
    public void flush(WritableByteChannel channel) throws IOException {
        while (!queue.isEmpty()) {
            Waiting first = queue.peekFirst();
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

    /** The connection is gone; what waited was for it alone. */
    public void clear() {
        queue.clear();
        speechFrames = 0;
    }

    /** A frame of which a part has left must leave whole, or the peer would lose the framing. */
    private void dropOldestSpeech() {
        for (Iterator<Waiting> each = queue.iterator(); each.hasNext(); ) {
            Waiting candidate = each.next();
            if (candidate.isSpeech && candidate.octets.position() == 0) {
                each.remove();
                speechFrames--;
                droppedSpeechFrames++;
                return;
            }
        }
    }
}
