package simgsm.abis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simgsm.abis.RateLimitedFrameReader.Portion;
import simgsm.air.ProtocolViolation;
import simgsm.timer.RateLimit;

class RateLimitedFrameReaderTest {
    private static final long MILLI = 1_000_000;

    private final List<Integer> received = new ArrayList<>();

    /** Frames whose only octet is their number. */
    private static ByteBuffer frames(int count) {
        ByteBuffer wire = ByteBuffer.allocate(4 * count);
        for (int i = 0; i < count; i++) {
            wire.put(IpaFramer.encode(new IpaFrame(IpaFrame.RSL, new byte[] {(byte) i})));
        }
        return wire.flip();
    }

    private Portion read(RateLimitedFrameReader reader, long nowNanos) throws ProtocolViolation {
        return reader.read(nowNanos, frame -> received.add((int) frame.payload()[0]));
    }

    private void expectFirst(int count) {
        assertEquals(IntStream.range(0, count).boxed().toList(), received);
    }

    @Test
    void aFullPortionLetsOthersGoFirstAndTheRestFollows() throws ProtocolViolation {
        RateLimitedFrameReader reader = new RateLimitedFrameReader(new RateLimit(1_000, 1_000));
        reader.accept(frames(100));

        assertEquals(Portion.FULL, read(reader, 0));
        expectFirst(RateLimitedFrameReader.FRAMES_PER_PORTION);
        assertEquals(Portion.COMPLETE, read(reader, 0));
        expectFirst(100);
    }

    @Test
    void aPeerAboveItsRateWaitsAndLosesNothing() throws ProtocolViolation {
        RateLimitedFrameReader reader = new RateLimitedFrameReader(new RateLimit(1_000, 10));
        reader.accept(frames(15));

        assertEquals(Portion.TOO_FAST, read(reader, 0));
        expectFirst(10);
        assertEquals(Portion.TOO_FAST, read(reader, MILLI - 1));
        expectFirst(10);
        assertEquals(Portion.TOO_FAST, read(reader, 3 * MILLI));
        expectFirst(13);
        assertEquals(Portion.COMPLETE, read(reader, 20 * MILLI));
        expectFirst(15);
    }

    @Test
    void anIncompleteFrameWaitsForItsRestAndCostsNothing() throws ProtocolViolation {
        RateLimitedFrameReader reader = new RateLimitedFrameReader(new RateLimit(1, 2));
        ByteBuffer wire = frames(2);
        reader.accept(wire.slice(0, 6));
        assertEquals(Portion.COMPLETE, read(reader, 0));
        assertEquals(Portion.COMPLETE, read(reader, 0));
        expectFirst(1);
        reader.accept(wire.slice(6, 2));
        assertEquals(Portion.TOO_FAST, read(reader, 0));
        expectFirst(2);
    }

    @Test
    void framesBeforeAViolationArrive() {
        RateLimitedFrameReader reader = new RateLimitedFrameReader(new RateLimit(1_000, 1_000));
        reader.accept(frames(3));
        reader.accept(ByteBuffer.wrap(new byte[] {(byte) 0xff, (byte) 0xff, 0}));
        assertThrows(ProtocolViolation.class, () -> read(reader, 0));
        expectFirst(3);
    }
}
