package simgsm.net;

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

class OutputQueueTest {
    private static final int MOST = 30;
    private static final int MOST_SPEECH = 10;
    /** Length of a message; its first octet is its length, its second a mark. */
    private static final int LENGTH = 6;

    /** A peer that takes a number of octets and then no more. */
    private static final class Peer implements WritableByteChannel {
        final ByteArrayOutputStream taken = new ByteArrayOutputStream();
        final List<Integer> writes = new ArrayList<>();
        int room = Integer.MAX_VALUE;

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

        /** The marks of the messages that have arrived; fails if one has not arrived whole. */
        List<Integer> messages() {
            byte[] octets = taken.toByteArray();
            List<Integer> marks = new ArrayList<>();
            for (int i = 0; i < octets.length; i += LENGTH) {
                assertEquals(LENGTH, octets[i], "the octet at " + i + " begins a message");
                marks.add((int) octets[i + 1]);
            }
            return marks;
        }
    }

    private final Peer peer = new Peer();
    private final List<Integer> written = new ArrayList<>();
    private final OutputQueue outgoing = new OutputQueue(MOST, MOST_SPEECH, message -> written.add((int) message[1]));

    private boolean send(int mark, boolean isSpeech) throws IOException {
        boolean isFirst = outgoing.isEmpty();
        boolean isTaken = outgoing.add(new byte[] {LENGTH, (byte) mark, 0, 0, 0, 0}, isSpeech);
        if (isFirst) {
            outgoing.flush(peer);
        }
        return isTaken;
    }

    @Test
    void whileThePeerKeepsUpEachFrameIsAWriteOfItsOwn() throws IOException {
        send(1, false);
        send(2, true);
        assertEquals(List.of(6, 6), peer.writes);
        assertTrue(outgoing.isEmpty());
    }

    @Test
    void speechThatWaitsOneBehindTheOtherSharesAWriteAndSignallingHasItsOwn() throws IOException {
        peer.room = 2;
        send(1, true);
        send(2, true);
        send(3, true);
        send(100, false);
        send(101, false);
        send(4, true);
        peer.room = 9;
        outgoing.flush(peer);
        peer.room = Integer.MAX_VALUE;
        outgoing.flush(peer);
        assertEquals(List.of(2, 9, 7, 6, 6, 6), peer.writes);
        assertEquals(List.of(1, 2, 3, 100, 101, 4), peer.messages());
        assertEquals(List.of(1, 2, 3, 100, 101, 4), written);
        assertTrue(outgoing.isEmpty());
    }

    @Test
    void aFrameThatLeavesInPartsStaysWholeAndInOrder() throws Exception {
        peer.room = 4;
        send(1, false);
        send(2, false);
        assertFalse(outgoing.isEmpty());
        peer.room = 1;
        outgoing.flush(peer);
        assertEquals(0, outgoing.taken());
        peer.room = Integer.MAX_VALUE;
        outgoing.flush(peer);
        assertEquals(List.of(1, 2), peer.messages());
        assertEquals(2, outgoing.taken());
        assertTrue(outgoing.isEmpty());
        assertArrayEquals(new byte[] {LENGTH, 1, 0, 0, 0, 0}, java.util.Arrays.copyOf(peer.taken.toByteArray(), 6));
    }

    @Test
    void speechOver200MillisecondsDropsItsOldestAndKeepsSignalling() throws Exception {
        peer.room = 0;
        send(100, false);
        for (int i = 1; i <= 13; i++) {
            send(i, true);
        }
        send(101, false);
        peer.room = Integer.MAX_VALUE;
        outgoing.flush(peer);
        assertEquals(List.of(100, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 101), peer.messages());
        assertEquals(3, outgoing.dropped());
    }

    @Test
    void aSpeechFrameOfWhichAPartHasLeftIsNotTheOneDropped() throws Exception {
        peer.room = 2;
        for (int i = 1; i <= 11; i++) {
            send(i, true);
        }
        peer.room = Integer.MAX_VALUE;
        outgoing.flush(peer);
        assertEquals(List.of(1, 3, 4, 5, 6, 7, 8, 9, 10, 11), peer.messages());
        assertEquals(1, outgoing.dropped());
    }

    @Test
    void aPeerThatTakesNoSignallingAnyMoreIsReported() throws IOException {
        peer.room = 0;
        for (int i = 0; i < MOST; i++) {
            assertTrue(send(1, false));
        }
        assertFalse(send(1, false));
    }

    @Test
    void speechDoesNotCountAsSignallingThatIsNotTaken() throws IOException {
        peer.room = 0;
        for (int i = 0; i < 3 * MOST; i++) {
            assertTrue(send(1, true));
        }
        assertEquals(MOST_SPEECH, outgoing.size());
    }

    @Test
    void signallingIsNeverDroppedForSpeech() throws Exception {
        peer.room = 0;
        for (int i = 1; i <= 20; i++) {
            send(100, false);
            send(i, true);
        }
        peer.room = Integer.MAX_VALUE;
        outgoing.flush(peer);
        assertEquals(20, peer.messages().stream().filter(mark -> mark == 100).count());
    }
}
