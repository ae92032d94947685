package simgsm.cells.mobile;

import java.util.OptionalInt;
import java.util.function.IntConsumer;
import simgsm.abis.IpaFrame;
import simgsm.abis.RtpPacket;
import simgsm.air.ProtocolViolation;
import simgsm.timer.Timers;

/** The speech of one mobile in both directions, and the silence during a handover. */
final class MobileSpeech {
    private static final long NANOS_PER_MILLI = 1_000_000;
    private static final int FRAME_MILLIS = 20;
    /** A larger jump means another stream. */
    private static final int MOST_FRAMES = 500;
    /** A larger jump backwards also means another stream; 1 s, as in the terminals. */
    private static final int MOST_REPEATED_FRAMES = 50;

    private static final long NONE = Long.MIN_VALUE;

    private final MobilePort port;
    private final Timers timers;
    private final UplinkSpeech uplink = new UplinkSpeech();
    private final IntConsumer gapEnded;
    private long deliveredNanos = NONE;
    private byte[] delivered = {};
    private boolean isHandedOver;
    private OptionalInt gap = OptionalInt.empty();

    /** @param gapEnded receives the length of each gap in milliseconds */
    MobileSpeech(MobilePort port, Timers timers, IntConsumer gapEnded) {
        this.port = port;
        this.timers = timers;
        this.gapEnded = gapEnded;
    }

    OptionalInt gapMillis() {
        return gap;
    }

    /** Restarts with a new traffic channel of the same or another call. */
    void restart() {
        uplink.restart();
    }

    byte[] convert(byte[] rtp) throws ProtocolViolation {
        return uplink.convert(rtp);
    }

    /** Handles the end of the old cell's speech, or of the call. */
    void handoverBegan() {
        isHandedOver = deliveredNanos != NONE;
    }

    void callEnded() {
        deliveredNanos = NONE;
        isHandedOver = false;
    }

    /**
     * Passes a frame to the terminal. The controller may send frames to both cells of a handover; the first ones of the
     * new cell are dropped if they were received in the old one.
     */
    void deliver(byte[] rtp) {
        long now = timers.nowNanos();
        if (isHandedOver) {
            int millis = gapMillis(rtp, now);
            if (millis < 0) {
                return;
            }
            isHandedOver = false;
            gap = OptionalInt.of(millis);
            gapEnded.accept(millis);
        }
        port.send(new IpaFrame(IpaFrame.SPEECH, rtp));
        deliveredNanos = now;
        delivered = rtp;
    }

    /**
     * The duration of missed frames, counted by RTP; in another stream the time between the frames. Negative for a
     * received frame.
     */
    private int gapMillis(byte[] rtp, long nowNanos) {
        try {
            RtpPacket last = RtpPacket.decode(delivered);
            RtpPacket first = RtpPacket.decode(rtp);
            int missed = (short) (first.sequence() - last.sequence()) - 1;
            if (first.source() == last.source() && missed >= -MOST_REPEATED_FRAMES && missed <= MOST_FRAMES) {
                return missed * FRAME_MILLIS;
            }
        } catch (ProtocolViolation broken) {
            // the terminal drops it; the gap is measured by time as well
        }
        return Math.max(0, (int) ((nowNanos - deliveredNanos) / NANOS_PER_MILLI) - FRAME_MILLIS);
    }
}
