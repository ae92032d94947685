package simgsm.station;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import simgsm.air.IpaFrame;
import simgsm.air.IpaFramer;

/**
 * What a connection has not taken yet, whole frames in order. Each frame is a write of its own, so that an observer of the
 * line sees one message a segment; one that is taken in part goes on where it stopped. Signalling is never lost; of speech
 * no more than 200 ms wait, older frames give way.
 */
final class OutgoingQueue {
    /** 200 ms in frames of 20 ms. */
    static final int MOST_SPEECH_FRAMES = 10;

    /** A peer that lets so much pile up reads nothing any more. */
    static final int MOST_FRAMES = 10_000;

    private static final class Waiting {
        final boolean speech;
        final ByteBuffer octets;

        Waiting(IpaFrame frame) {
            speech = frame.stream() == IpaFrame.SPEECH;
            octets = ByteBuffer.wrap(IpaFramer.encode(frame));
        }

        boolean isBegun() {
            return octets.position() > 0;
        }
    }

    private final Deque<Waiting> frames = new ArrayDeque<>();
    private int speechFrames;
    private long droppedSpeechFrames;

    boolean isEmpty() {
        return frames.isEmpty();
    }

    boolean isFull() {
        return frames.size() >= MOST_FRAMES;
    }

    long droppedSpeechFrames() {
        return droppedSpeechFrames;
    }

    void add(IpaFrame frame) {
        Waiting waiting = new Waiting(frame);
        if (waiting.speech && speechFrames >= MOST_SPEECH_FRAMES) {
            dropOldestSpeech();
        }
        frames.add(waiting);
        speechFrames += waiting.speech ? 1 : 0;
    }

    private void dropOldestSpeech() {
        for (Iterator<Waiting> all = frames.iterator(); all.hasNext(); ) {
            Waiting candidate = all.next();
            if (candidate.speech && !candidate.isBegun()) {
                all.remove();
                speechFrames--;
                droppedSpeechFrames++;
                return;
            }
        }
    }

    /** Writes what the channel takes now. */
    void writeTo(WritableByteChannel channel) throws IOException {
        for (Waiting first = frames.peek(); first != null; first = frames.peek()) {
            channel.write(first.octets);
            if (first.octets.hasRemaining()) {
                return;
            }
            frames.remove();
            speechFrames -= first.speech ? 1 : 0;
        }
    }

    void clear() {
        frames.clear();
        speechFrames = 0;
    }
}
