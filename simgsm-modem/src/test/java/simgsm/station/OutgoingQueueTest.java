package simgsm.station;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.air.IpaFrame;

class OutgoingQueueTest {
    /** Takes so many octets and no more until told otherwise. */
    private static final class Line implements WritableByteChannel {
        final ByteArrayOutputStream taken = new ByteArrayOutputStream();
        final List<Integer> writes = new ArrayList<>();
        int room;

        @Override
        public int write(ByteBuffer source) {
            int count = Math.min(room, source.remaining());
            for (int i = 0; i < count; i++) {
                taken.write(source.get());
            }
            room -= count;
            writes.add(count);
            return count;
        }

        @Override
        public boolean isOpen() {
            return true;
        }

        @Override
        public void close() {}
    }

    private final OutgoingQueue queue = new OutgoingQueue();
    private final Line line = new Line();

    private static IpaFrame signalling(int mark) {
        return new IpaFrame(IpaFrame.RSL, new byte[] {(byte) mark});
    }

    private static IpaFrame speech(int mark) {
        return new IpaFrame(IpaFrame.SPEECH, new byte[] {(byte) mark});
    }

    private List<Integer> marksTaken() {
        byte[] octets = line.taken.toByteArray();
        List<Integer> marks = new ArrayList<>();
        for (int i = 3; i < octets.length; i += 4) {
            marks.add((int) octets[i]);
        }
        return marks;
    }

    @Test
    void eachFrameIsAWriteOfItsOwn() throws IOException {
        line.room = 100;
        queue.add(signalling(1));
        queue.add(signalling(2));
        queue.writeTo(line);
        assertEquals(List.of(4, 4), line.writes);
        assertTrue(queue.isEmpty());
    }

    @Test
    void aFrameTakenInPartGoesOnWhereItStopped() throws IOException {
        queue.add(signalling(1));
        queue.add(signalling(2));
        line.room = 3;
        queue.writeTo(line);
        assertFalse(queue.isEmpty());
        line.room = 2;
        queue.writeTo(line);
        line.room = 100;
        queue.writeTo(line);
        assertArrayEquals(new byte[] {0, 1, 0, 1, 0, 1, 0, 2}, line.taken.toByteArray());
    }

    @Test
    void ofSpeechTheNewest200MillisecondsWaitAndTheRestIsCounted() throws IOException {
        for (int mark = 0; mark < 13; mark++) {
            queue.add(speech(mark));
        }
        assertEquals(3, queue.droppedSpeechFrames());
        line.room = 1000;
        queue.writeTo(line);
        assertEquals(List.of(3, 4, 5, 6, 7, 8, 9, 10, 11, 12), marksTaken());
    }

    @Test
    void aFrameThatIsBegunIsNeverDropped() throws IOException {
        queue.add(speech(0));
        line.room = 2;
        queue.writeTo(line);
        for (int mark = 1; mark <= 10; mark++) {
            queue.add(speech(mark));
        }
        assertEquals(1, queue.droppedSpeechFrames());
        line.room = 1000;
        queue.writeTo(line);
        assertEquals(List.of(0, 2, 3, 4, 5, 6, 7, 8, 9, 10), marksTaken());
    }

    @Test
    void signallingIsNeverDroppedForSpeech() throws IOException {
        for (int mark = 0; mark < 20; mark++) {
            queue.add(signalling(100 + mark));
            queue.add(speech(mark));
        }
        line.room = 1000;
        queue.writeTo(line);
        assertEquals(20, marksTaken().stream().filter(mark -> mark >= 100).count());
        assertEquals(10, marksTaken().stream().filter(mark -> mark < 100).count());
    }

    @Test
    void tenThousandFramesAreTooMany() {
        for (int i = 0; i < 9_999; i++) {
            queue.add(signalling(1));
        }
        assertFalse(queue.isFull());
        queue.add(signalling(1));
        assertTrue(queue.isFull());
    }
}
