package simgsm.abis;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simgsm.air.ProtocolViolation;

class IpaFramerTest {
    @Test
    void aFrameIsLengthStreamAndPayload() {
        byte[] wire = IpaFramer.encode(new IpaFrame(IpaFrame.CCM, new byte[] {0x05, 0x06}));

        assertArrayEquals(new byte[] {0, 2, (byte) 0xfe, 5, 6}, wire);
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 1000, 100_000})
    void framesComeOutWholeHoweverTheyArriveInPieces(int pieceLength) throws ProtocolViolation {
        List<IpaFrame> sent = randomFrames(500);
        ByteBuffer wire = onTheWire(sent);
        IpaFramer framer = new IpaFramer();
        List<IpaFrame> received = new ArrayList<>();
        while (wire.hasRemaining()) {
            int end = Math.min(wire.limit(), wire.position() + pieceLength);
            framer.accept(wire.slice(wire.position(), end - wire.position()));
            wire.position(end);
            framer.next().ifPresent(received::add);
        }
        for (var next = framer.next(); next.isPresent(); next = framer.next()) {
            received.add(next.get());
        }

        assertEquals(sent.size(), received.size());
        for (int i = 0; i < sent.size(); i++) {
            assertEquals(sent.get(i).stream(), received.get(i).stream());
            assertArrayEquals(sent.get(i).payload(), received.get(i).payload());
        }
    }

    @Test
    void anEmptyFrameIsAFrame() throws ProtocolViolation {
        IpaFramer framer = new IpaFramer();
        framer.accept(ByteBuffer.wrap(new byte[] {0, 0, 9}));

        assertEquals(9, framer.next().orElseThrow().stream());
        assertTrue(framer.next().isEmpty());
    }

    @Test
    void theLongestFramePasses() throws ProtocolViolation {
        IpaFramer framer = new IpaFramer();
        framer.accept(ByteBuffer.wrap(IpaFramer.encode(new IpaFrame(1, new byte[IpaFrame.MAX_PAYLOAD]))));

        assertEquals(IpaFrame.MAX_PAYLOAD, framer.next().orElseThrow().payload().length);
    }

    @Test
    void aLongerFrameIsRefusedBeforeItHasArrivedAndForEver() {
        IpaFramer framer = new IpaFramer();
        framer.accept(ByteBuffer.wrap(new byte[] {0x04, 0x01, 0}));

        ProtocolViolation first = assertThrows(ProtocolViolation.class, framer::next);
        assertTrue(first.getMessage().contains("1025"), first.getMessage());
        framer.accept(ByteBuffer.wrap(new byte[2000]));
        assertThrows(ProtocolViolation.class, framer::next);
    }

    @Test
    void aFrameThatTheOtherSideWouldRefuseIsNotMade() {
        assertThrows(IllegalArgumentException.class, () -> new IpaFrame(0, new byte[IpaFrame.MAX_PAYLOAD + 1]));
        assertThrows(IllegalArgumentException.class, () -> new IpaFrame(256, new byte[1]));
        assertThrows(IllegalArgumentException.class, () -> new IpaFrame(-1, new byte[1]));
    }

    private static List<IpaFrame> randomFrames(int count) {
        Random random = new Random(3003);
        List<IpaFrame> frames = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            byte[] payload = new byte[random.nextInt(IpaFrame.MAX_PAYLOAD + 1)];
            random.nextBytes(payload);
            frames.add(new IpaFrame(random.nextInt(256), payload));
        }
        return frames;
    }

    private static ByteBuffer onTheWire(List<IpaFrame> frames) {
        ByteBuffer wire = ByteBuffer.allocate(
                frames.stream().mapToInt(frame -> 3 + frame.payload().length).sum());
        frames.forEach(frame -> wire.put(IpaFramer.encode(frame)));
        return wire.flip();
    }
}
