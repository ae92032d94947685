package simgsm.phone.handset;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.air.Cause;
import simgsm.dtmf.DtmfKey;
import simgsm.dtmf.DtmfReceiver;
import simgsm.dtmf.ToneExperiment;
import simgsm.dtmf.ToneSet;
import simgsm.dtmf.ToneTrace;
import simgsm.speech.AudioOutput;

/**
 * Everything that sounds: keys on their way to the far end, the far end's tones, and, without a call, the keys' own
 * sound and the supervisory tones. While the station brings and takes speech its frames give the beat, else the time that
 * is told.
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
    private final SupervisoryTones supervisory;
    private final short[] localFrame = new short[SAMPLES_PER_FRAME];
    /** What is heard here of what is said, or the other way round. */
    private final short[] otherFrame = new short[SAMPLES_PER_FRAME];

    private boolean connected;
    /** Whether the network's tones are heard, before a call is connected or after its end. */
    private boolean hearsNetwork;

    private Runnable timeWanted = () -> {};
    private int localFramesLeft;
    private boolean localTimeKnown;
    private long nextLocalFrameNanos;

    /**
     * @param line takes keys to the far end
     * @param tones of the part of the world that the phone is at home in
     * @param heard told each key of the far end as it is decided
     */
    Sounds(AudioOutput output, KeySender line, ToneSet tones, Consumer<DtmfKey> heard) {
        earpiece = new Earpiece(output);
        supervisory = new SupervisoryTones(tones);
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

    /** No supervisory tone of our own any more. */
    void quiet() {
        supervisory.stop();
    }

    void callBegan() {
        line.drop();
        quiet();
    }

    /** We are called. */
    void ringing() {
        supervisory.ringing();
        beginLocally();
    }

    /** The other phone rings; where the network lets that be heard itself, that is enough. */
    void ringBack() {
        if (!hearsNetwork) {
            supervisory.ringBack();
            beginLocally();
        }
    }

    /** The network lets its own tones be heard from now on, or no more. */
    void networkTones(boolean heard) {
        if (heard != hearsNetwork) {
            hearsNetwork = heard;
            quiet();
            earpiece.callEnded();
            beginLocally();
        }
    }

    boolean hearsNetwork() {
        return hearsNetwork;
    }

    void connected() {
        connected = true;
        hearsNetwork = false;
        ear.reset();
        local.drop();
        quiet();
        localFramesLeft = 0;
    }

    void callEnded(Cause cause) {
        connected = false;
        line.drop();
        earpiece.callEnded();
        supervisory.ended(cause);
        beginLocally();
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
        if (!connected) {
            Arrays.fill(frame, (short) 0);
            return hearsNetwork && localFrame();
        }
        DtmfKey before = line.sounding();
        line.read(frame, otherFrame);
        earpiece.said(otherFrame);
        return earpiece.pollChanged() || before != line.sounding();
    }

    /** The far end's next 20 ms, or the network's; what the network plays is no key, nor is our own call waiting tone. */
    void hear(short[] frame) {
        if (connected) {
            ear.accept(frame);
        }
        if (connected && !supervisory.isIdle()) {
            short[] mixed = frame.clone();
            supervisory.addTo(mixed);
            earpiece.heard(mixed);
        } else if (connected || hearsNetwork) {
            earpiece.heard(frame);
        }
    }

    /** Somebody else calls in the middle of a call. */
    void callWaits() {
        supervisory.callWaits();
    }

    /** The key that sounds now. */
    Optional<DtmfKey> sounding() {
        return Optional.ofNullable((connected ? line : local).sounding());
    }

    void tryOut(ToneExperiment experiment) {
        earpiece.tryOut(experiment);
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
        return localFramesLeft > 0 && !hearsNetwork;
    }

    /** @return whether what a view shows has changed */
    boolean timePassed(long nowNanos) {
        if (!localTimeKnown || nowNanos - nextLocalFrameNanos > LONGEST_CATCH_UP_NANOS) {
            nextLocalFrameNanos = nowNanos;
            localTimeKnown = true;
        }
        boolean changed = false;
        while (wantsTime() && nextLocalFrameNanos <= nowNanos) {
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
        localFramesLeft = quiet ? Math.max(0, localFramesLeft - 1) : TAIL_FRAMES;
        if (localFramesLeft == 0 && !hearsNetwork) {
            earpiece.rest();
        }
        return earpiece.pollChanged() || before != local.sounding();
    }
}
