package simgsm.center.net;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.abis.RateLimitedFrameReader;
import simgsm.air.ProtocolViolation;

/** With a clock moved by hand: how many frames of one peer are read. */
class TerminalRateTest {
    private static final long SECOND = 1_000_000_000;

    private final List<IpaFrame> read = new ArrayList<>();

    private static ByteBuffer frames(int count) {
        byte[] one = IpaFramer.encode(new IpaFrame(IpaFrame.CCM, new byte[] {0}));
        ByteBuffer all = ByteBuffer.allocate(count * one.length);
        for (int i = 0; i < count; i++) {
            all.put(one);
        }
        return all.flip();
    }

    private RateLimitedFrameReader.Portion readPortion(RateLimitedFrameReader reader, long nowNanos)
            throws ProtocolViolation {
        return reader.read(nowNanos, read::add);
    }

    @Test
    void whatFitsIntoAPortionIsReadAtOnce() throws ProtocolViolation {
        RateLimitedFrameReader reader = new RateLimitedFrameReader(TerminalConnection.rate(false));
        reader.accept(frames(RateLimitedFrameReader.FRAMES_PER_PORTION - 1));
        assertEquals(RateLimitedFrameReader.Portion.COMPLETE, readPortion(reader, 0));
        assertEquals(RateLimitedFrameReader.FRAMES_PER_PORTION - 1, read.size());
    }

    @Test
    void framesBeyondAPortionAreReadInTheNext() throws ProtocolViolation {
        RateLimitedFrameReader reader = new RateLimitedFrameReader(TerminalConnection.rate(false));
        reader.accept(frames(RateLimitedFrameReader.FRAMES_PER_PORTION + 1));
        assertEquals(RateLimitedFrameReader.Portion.FULL, readPortion(reader, 0));
        assertEquals(RateLimitedFrameReader.FRAMES_PER_PORTION, read.size());
        assertEquals(RateLimitedFrameReader.Portion.COMPLETE, readPortion(reader, 0));
        assertEquals(RateLimitedFrameReader.FRAMES_PER_PORTION + 1, read.size());
    }

    @Test
    void aFloodFromAnotherMachineIsReadNoFasterThanItsRateAndNothingIsLost() throws ProtocolViolation {
        RateLimitedFrameReader reader = new RateLimitedFrameReader(TerminalConnection.rate(false));
        int flood = 16_000;
        reader.accept(frames(flood));
        assertEquals(TerminalConnection.REMOTE_BURST_FRAMES, readAt(reader, 0));
        assertEquals(
                TerminalConnection.REMOTE_FRAMES_PER_SECOND,
                readAt(reader, SECOND) - TerminalConnection.REMOTE_BURST_FRAMES);
        for (int second = 2; read.size() < flood; second++) {
            readAt(reader, second * SECOND);
        }
        assertEquals(flood, read.size());
        assertEquals(RateLimitedFrameReader.Portion.COMPLETE, readPortion(reader, 100 * SECOND));
    }

    @Test
    void terminalsOfThisMachineHaveAHigherRate() throws ProtocolViolation {
        RateLimitedFrameReader reader = new RateLimitedFrameReader(TerminalConnection.rate(true));
        reader.accept(frames(2 * TerminalConnection.LOCAL_BURST_FRAMES));
        assertEquals(TerminalConnection.LOCAL_BURST_FRAMES, readAt(reader, 0));
    }

    /** A second's speech and signalled keys of a call, for an hour, and three seconds' worth at once after a stall. */
    @Test
    void aCallStaysBelowTheRate() throws ProtocolViolation {
        RateLimitedFrameReader reader = new RateLimitedFrameReader(TerminalConnection.rate(false));
        for (int second = 0; second < 3_600; second++) {
            int count = second % 60 == 0 ? 3 * 60 : 60;
            reader.accept(frames(count));
            int before = read.size();
            assertEquals(before + count, readAt(reader, second * SECOND));
        }
    }

    /** Reads until no whole frame is left or the rate is reached. */
    private int readAt(RateLimitedFrameReader reader, long nowNanos) throws ProtocolViolation {
        RateLimitedFrameReader.Portion portion = readPortion(reader, nowNanos);
        while (portion == RateLimitedFrameReader.Portion.FULL) {
            portion = readPortion(reader, nowNanos);
        }
        return read.size();
    }
}
