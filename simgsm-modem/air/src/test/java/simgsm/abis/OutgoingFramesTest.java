package simgsm.abis;

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
import simgsm.air.ProtocolViolation;

class OutgoingFramesTest {
    private static final int MOST_SIGNALLING_FRAMES = 30;

    /** A peer that takes so many octets and then no more. */
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

        /** The first payload octets of the frames that have arrived whole. */
        List<Integer> frames() throws ProtocolViolation {
            IpaFramer framer = new IpaFramer();
            framer.accept(ByteBuffer.wrap(taken.toByteArray()));
            List<Integer> marks = new ArrayList<>();
            for (var frame = framer.next(); frame.isPresent(); frame = framer.next()) {
                marks.add((int) frame.get().payload()[0]);
            }
            return marks;
        }
    }

    private final Peer peer = new Peer();
    private final OutgoingFrames outgoing = new OutgoingFrames(MOST_SIGNALLING_FRAMES);

    private static IpaFrame speech(int mark) {
        return new IpaFrame(IpaFrame.SPEECH, new byte[] {(byte) mark, 0, 0});
    }

    private static IpaFrame signalling(int mark) {
        return new IpaFrame(IpaFrame.RSL, new byte[] {(byte) mark, 0, 0});
    }

    @Test
    void whileThePeerKeepsUpEachFrameIsAWriteOfItsOwn() throws IOException {
        outgoing.send(signalling(1), peer);
        outgoing.send(speech(2), peer);
        assertEquals(List.of(6, 6), peer.writes);
        assertTrue(outgoing.isEmpty());
    }

    @Test
    void aFrameThatLeavesInPartsStaysWholeAndInOrder() throws Exception {
        peer.room = 4;
        outgoing.send(signalling(1), peer);
        outgoing.send(signalling(2), peer);
        assertFalse(outgoing.isEmpty());
        peer.room = 1;
        outgoing.flush(peer);
        peer.room = Integer.MAX_VALUE;
        outgoing.flush(peer);
        assertEquals(List.of(1, 2), peer.frames());
        assertTrue(outgoing.isEmpty());
        assertArrayEquals(new byte[] {0, 3, 0, 1, 0, 0}, java.util.Arrays.copyOf(peer.taken.toByteArray(), 6));
    }

    @Test
    void speechOver200MillisecondsDropsItsOldestAndKeepsSignalling() throws Exception {
        peer.room = 0;
        outgoing.send(signalling(100), peer);
        for (int i = 1; i <= 13; i++) {
            outgoing.send(speech(i), peer);
        }
        outgoing.send(signalling(101), peer);
        peer.room = Integer.MAX_VALUE;
        outgoing.flush(peer);
        assertEquals(List.of(100, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 101), peer.frames());
        assertEquals(3, outgoing.droppedSpeechFrames());
    }

    @Test
    void aSpeechFrameOfWhichAPartHasLeftIsNotTheOneDropped() throws Exception {
        peer.room = 2;
        for (int i = 1; i <= 11; i++) {
            outgoing.send(speech(i), peer);
        }
        peer.room = Integer.MAX_VALUE;
        outgoing.flush(peer);
        assertEquals(List.of(1, 3, 4, 5, 6, 7, 8, 9, 10, 11), peer.frames());
        assertEquals(1, outgoing.droppedSpeechFrames());
    }

    @Test
    void aPeerThatTakesNoSignallingAnyMoreIsReported() throws IOException {
        peer.room = 0;
        for (int i = 0; i < MOST_SIGNALLING_FRAMES; i++) {
            assertTrue(outgoing.send(signalling(1), peer));
        }
        assertFalse(outgoing.send(signalling(1), peer));
    }

    @Test
    void speechDoesNotCountAsSignallingThatIsNotTaken() throws IOException {
        peer.room = 0;
        for (int i = 0; i < 3 * MOST_SIGNALLING_FRAMES; i++) {
            assertTrue(outgoing.send(speech(1), peer));
        }
        assertEquals(OutgoingFrames.MOST_SPEECH_FRAMES, outgoing.size());
    }

    @Test
    void signallingIsNeverDroppedForSpeech() throws Exception {
        peer.room = 0;
        for (int i = 1; i <= 20; i++) {
            outgoing.send(signalling(100), peer);
            outgoing.send(speech(i), peer);
        }
        peer.room = Integer.MAX_VALUE;
        outgoing.flush(peer);
        assertEquals(20, peer.frames().stream().filter(mark -> mark == 100).count());
    }

    @Test
    void whatWaitedForALostConnectionIsForgotten() throws Exception {
        peer.room = 0;
        outgoing.send(speech(1), peer);
        outgoing.send(signalling(2), peer);
        outgoing.clear();
        assertTrue(outgoing.isEmpty());
        for (int i = 1; i <= OutgoingFrames.MOST_SPEECH_FRAMES; i++) {
            outgoing.send(speech(i), peer);
        }
        assertEquals(0, outgoing.droppedSpeechFrames());
    }
}
