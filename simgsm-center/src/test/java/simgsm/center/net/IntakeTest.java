package simgsm.center.net;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.air.ProtocolViolation;

/** With a clock moved by hand: what one peer may have done before the others. */
class IntakeTest {
    private static final long SECOND = 1_000_000_000;

    private final List<IpaFrame> handed = new ArrayList<>();

    private static ByteBuffer frames(int count) {
        byte[] one = IpaFramer.encode(new IpaFrame(IpaFrame.CCM, new byte[] {0}));
        ByteBuffer all = ByteBuffer.allocate(count * one.length);
        for (int i = 0; i < count; i++) {
            all.put(one);
        }
        return all.flip();
    }

    private RateLimitedFrameReader.Rest hand(RateLimitedFrameReader intake, long nowNanos) throws ProtocolViolation {
        return intake.hand(nowNanos, handed::add);
    }

    @Test
    void whatFitsIntoATurnIsHandedOnAtOnce() throws ProtocolViolation {
        RateLimitedFrameReader intake = new RateLimitedFrameReader(false);
        intake.accept(frames(RateLimitedFrameReader.FRAMES_A_TURN - 1));
        assertEquals(RateLimitedFrameReader.Rest.NONE, hand(intake, 0));
        assertEquals(RateLimitedFrameReader.FRAMES_A_TURN - 1, handed.size());
    }

    @Test
    void whoeverSendsMoreThanATurnHoldsWaitsForTheNext() throws ProtocolViolation {
        RateLimitedFrameReader intake = new RateLimitedFrameReader(false);
        intake.accept(frames(RateLimitedFrameReader.FRAMES_A_TURN + 1));
        assertEquals(RateLimitedFrameReader.Rest.FOR_ANOTHER_TURN, hand(intake, 0));
        assertEquals(RateLimitedFrameReader.FRAMES_A_TURN, handed.size());
        assertEquals(RateLimitedFrameReader.Rest.NONE, hand(intake, 0));
        assertEquals(RateLimitedFrameReader.FRAMES_A_TURN + 1, handed.size());
    }

    @Test
    void aFloodFromAnotherMachineIsReadNoFasterThanItsAllowanceAndNothingIsLost() throws ProtocolViolation {
        RateLimitedFrameReader intake = new RateLimitedFrameReader(false);
        int flood = 16_000;
        intake.accept(frames(flood));
        assertEquals(RateLimitedFrameReader.REMOTE_BURST_FRAMES, handedAt(intake, 0));
        assertEquals(
                RateLimitedFrameReader.REMOTE_FRAMES_PER_SECOND,
                handedAt(intake, SECOND) - RateLimitedFrameReader.REMOTE_BURST_FRAMES);
        for (int second = 2; handed.size() < flood; second++) {
            handedAt(intake, second * SECOND);
        }
        assertEquals(flood, handed.size());
        assertEquals(RateLimitedFrameReader.Rest.NONE, hand(intake, 100 * SECOND));
    }

    @Test
    void thisMachinesTerminalsMayDoFarMore() throws ProtocolViolation {
        RateLimitedFrameReader intake = new RateLimitedFrameReader(true);
        intake.accept(frames(2 * RateLimitedFrameReader.LOCAL_BURST_FRAMES));
        assertEquals(RateLimitedFrameReader.LOCAL_BURST_FRAMES, handedAt(intake, 0));
    }

    /** A second's speech and signalled keys of a call, for an hour, and three seconds' worth at once after a stall. */
    @Test
    void aCallNeverReachesTheAllowance() throws ProtocolViolation {
        RateLimitedFrameReader intake = new RateLimitedFrameReader(false);
        for (int second = 0; second < 3_600; second++) {
            int count = second % 60 == 0 ? 3 * 60 : 60;
            intake.accept(frames(count));
            int before = handed.size();
            assertEquals(before + count, handedAt(intake, second * SECOND));
        }
    }

    /** Hands on until there is nothing more, or nothing more allowed. */
    private int handedAt(RateLimitedFrameReader intake, long nowNanos) throws ProtocolViolation {
        RateLimitedFrameReader.Rest rest = hand(intake, nowNanos);
        while (rest == RateLimitedFrameReader.Rest.FOR_ANOTHER_TURN) {
            rest = hand(intake, nowNanos);
        }
        return handed.size();
    }
}
