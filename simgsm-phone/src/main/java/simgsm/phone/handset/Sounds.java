package simgsm.phone.handset;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.air.Cause;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.dtmf.ToneTrace;
import simgsm.speech.AudioOutput;

/**
 * Everything that sounds: keys on their way to the far end, the far end's tones, and, without a call, the keys' own
 * sound and the supervisory tones. In a call the station's frames give the beat, else the time that is told.
 */
final class Sounds {
    private static final int SAMPLES_PER_FRAME = 160;
    private static final long FRAME_NANOS = TimeUnit.MILLISECONDS.toNanos(20);
    /** After a longer stall sound goes on where it was instead of being made up for. */
    private static final long LONGEST_CATCH_UP_NANOS = TimeUnit.MILLISECONDS.toNanos(200);
    /** So long frames go on after a sound, until the scope's picture is quiet. */
    private static final int TAIL_FRAMES = 8;

    private final Earpiece earpiece;
    private final KeySender line;
    private final KeySender local = new KeySender(keys -> {});
    private final DtmfReceiver ear;
    private final SupervisoryTonePlayer supervisory = new SupervisoryTonePlayer();
    private final short[] localFrame = new short[SAMPLES_PER_FRAME];
    /** What is heard here of what is said, or the other way round. */
    private final short[] otherFrame = new short[SAMPLES_PER_FRAME];

    private boolean connected;
    private Runnable timeWanted = () -> {};
    private int localFramesLeft;
    private boolean localTimeKnown;
    private long nextLocalFrameNanos;

    /**
     * @param line takes keys to the far end
     * @param heard told each key of the far end as it is decided
     */
    Sounds(AudioOutput output, KeySender line, Consumer<DtmfKey> heard) {
        earpiece = new Earpiece(output);
        this.line = line;
        ear = new DtmfReceiver(digit -> heard.accept(digit.key()));
    }

    /** Queues keys towards the far end; they leave once there is a call. */
    void press(List<DtmfKey> keys) {
        line.press(keys);
    }

    /** A key goes down and sounds until {@link #up}: to the far end in a call, else at the ear only. */
    void down(DtmfKey key) {
        if (connected) {
            line.down(key);
        } else {
            local.down(key);
            beginLocally();
        }
    }

    void up() {
        line.up();
        local.up();
    }

    /** Plays a supervisory tone, in place of the one that plays. */
    void supervise(SupervisoryTone tone) {
        supervisory.start(tone);
        if (tone != SupervisoryTone.NONE) {
            beginLocally();
        }
    }

    void callBegan() {
        line.drop();
        supervise(SupervisoryTone.NONE);
    }

    void connected() {
        connected = true;
        ear.reset();
        local.drop();
        supervise(SupervisoryTone.NONE);
        localFramesLeft = 0;
    }

    void callEnded(Cause cause) {
        connected = false;
        line.drop();
        earpiece.callEnded();
        beginLocally();
        supervise(SupervisoryTone.of(cause));
    }

    void dropKeys() {
        line.drop();
    }

    /** Whether every key pressed has left. */
    boolean keysHaveLeft() {
        return line.isIdle();
    }

    /** Fills the next 20 ms for the far end. @return whether what a view shows has changed */
    boolean say(short[] frame) {
        DtmfKey before = line.sounding();
        line.read(frame, otherFrame);
        earpiece.said(otherFrame);
        return earpiece.pollChanged() || before != line.sounding();
    }

    /** The far end's next 20 ms. */
    void hear(short[] frame) {
        earpiece.heard(frame);
        ear.accept(frame);
    }

    /** The key that sounds now. */
    Optional<DtmfKey> sounding() {
        return Optional.ofNullable((connected ? line : local).sounding());
    }

    ToneTrace trace() {
        return earpiece.trace();
    }

    boolean isAudible() {
        return earpiece.isAudible();
    }

    void whenTimeIsWanted(Runnable act) {
        timeWanted = act;
    }

    private void beginLocally() {
        boolean idle = localFramesLeft == 0;
        localFramesLeft = TAIL_FRAMES;
        if (idle) {
            localTimeKnown = false;
            timeWanted.run();
        }
    }

    boolean wantsTime() {
        return localFramesLeft > 0;
    }

    /** @return whether what a view shows has changed */
    boolean timePassed(long nowNanos) {
        if (!localTimeKnown || nowNanos - nextLocalFrameNanos > LONGEST_CATCH_UP_NANOS) {
            nextLocalFrameNanos = nowNanos;
            localTimeKnown = true;
        }
        boolean changed = false;
        while (localFramesLeft > 0 && nextLocalFrameNanos <= nowNanos) {
            changed |= localFrame();
            nextLocalFrameNanos += FRAME_NANOS;
        }
        return changed;
    }

    private boolean localFrame() {
        DtmfKey before = local.sounding();
        local.read(otherFrame, localFrame);
        supervisory.addTo(localFrame);
        earpiece.said(localFrame);
        boolean quiet = local.isIdle() && supervisory.isIdle();
        localFramesLeft = quiet ? localFramesLeft - 1 : TAIL_FRAMES;
        return earpiece.pollChanged() || before != local.sounding();
    }
}
