package simgsm.center.msc;

import java.nio.ByteBuffer;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import simgsm.abis.IpaFrame;
import simgsm.abis.RtpPacket;
import simgsm.air.CallControl;
import simgsm.air.Cause;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.speech.SpeechCodec;
import simgsm.timer.Timer;
import simgsm.timer.Timers;

/**
 * The network's tone sender at one leg of a call (TS 23.014): the keys that its mobile signals become sound for the other
 * party. While a key sounds, and in the pause after it, each speech frame of the mobile gives way to a frame of ours with
 * its own numbers; when none comes in time a frame goes out all the same. The sound is A-law, whatever the mobile speaks:
 * it begins behind the mobile's speech codec, and so stays clean.
 *
 * <p>A key sounds for as long as the mobile holds it, but for at least 70 ms and at most 30 s, and is followed by 65 ms of
 * silence at least. START DTMF is acknowledged at once, STOP DTMF when the tone has left.
 */
final class ToneSender {
    /** Keys that wait behind the one that sounds; a mobile that waits for acknowledgements never has any. */
    static final int MAX_KEYS = 32;

    static final int LONGEST_FRAMES = 1_500;

    private static final long FRAME_NANOS = TimeUnit.MILLISECONDS.toNanos(20);
    /** So long the mobile's next speech frame is waited for. */
    private static final long PATIENCE_NANOS = TimeUnit.MILLISECONDS.toNanos(40);

    private static final long NANOS_PER_SAMPLE = 125_000;
    /** Whose stream it is while the mobile has never spoken: "tone". */
    private static final int OWN_SOURCE = 0x746f6e65;

    /** A larger distance of sequence numbers is a new stream, not a late frame: 1 s. */
    private static final int LONGEST_LEAD_FRAMES = 50;

    private final CallLeg leg;
    private final Timers timers;
    private final SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
    private final DtmfGenerator generator = new DtmfGenerator(key -> toneLeft());
    /** From START DTMF to the tone's end, the sounding one first. */
    private final Deque<Held> keys = new ArrayDeque<>();

    private final short[] samples = new short[SpeechCodec.SAMPLES_PER_FRAME];
    private int heldFrames;
    private int acknowledgementsDue;
    private Timer patience;

    // The numbers of the next frame.
    private int source = OWN_SOURCE;
    private int sequence;
    private int timestamp;
    /** Whether frames of ours have gone out that the mobile's stream has not caught up with. */
    private boolean isAhead;

    private static final class Held {
        boolean isReleased;
        boolean awaitsAcknowledgement;
    }

    ToneSender(CallLeg leg, Timers timers) {
        this.leg = leg;
        this.timers = timers;
    }

    /** START DTMF. */
    void start(char key) {
        if (leg.listener() == null || !leg.state().speaks()) {
            reject(Cause.SERVICE_NOT_AVAILABLE);
        } else if (keys.size() == MAX_KEYS) {
            reject(Cause.RESOURCES_UNAVAILABLE);
        } else {
            if (generator.isIdle()) {
                begin();
            }
            if (!keys.isEmpty()) {
                keys.getLast().isReleased = true;
            }
            keys.add(new Held());
            generator.press(DtmfKey.of(key));
            leg.link().send(new CallControl.StartDtmfAcknowledge(leg.transaction(), key));
        }
    }

    private void reject(Cause cause) {
        leg.link().send(new CallControl.StartDtmfReject(leg.transaction(), cause));
    }

    private void begin() {
        if (source == OWN_SOURCE) {
            timestamp = (int) (timers.nowNanos() / NANOS_PER_SAMPLE);
        }
        waitFor(PATIENCE_NANOS);
    }

    /** STOP DTMF; one for a key that has ended already is acknowledged like any other. */
    void stop() {
        if (keys.isEmpty() || keys.getLast().isReleased) {
            acknowledgeStop();
        } else {
            keys.getLast().isReleased = true;
            keys.getLast().awaitsAcknowledgement = true;
            generator.release();
        }
    }

    /** The leg no longer speaks. */
    void end() {
        generator.drop();
        keys.clear();
        timers.cancel(patience);
    }

    /** What goes on in the place of the mobile's speech frame: itself, a tone's, or null if its time has passed. */
    IpaFrame inPlaceOf(IpaFrame speech) {
        ByteBuffer header = ByteBuffer.wrap(speech.payload());
        if (isAhead && isLate(header)) {
            return null;
        }
        isAhead = false;
        if (generator.isIdle()) {
            return speech;
        }
        sequence = header.getShort(2);
        timestamp = header.getInt(4);
        source = header.getInt(8);
        waitFor(PATIENCE_NANOS);
        return nextFrame();
    }

    private boolean isLate(ByteBuffer header) {
        int lead = (short) (header.getShort(2) - sequence);
        return header.getInt(8) == source && lead < 0 && lead >= -LONGEST_LEAD_FRAMES;
    }

    private void waitFor(long nanos) {
        timers.cancel(patience);
        patience = timers.start(nanos, this::noSpeechInTime);
    }

    private void noSpeechInTime() {
        CallLeg listener = leg.listener();
        if (listener != null) {
            isAhead = true;
            waitFor(FRAME_NANOS);
            listener.link().port.send(nextFrame());
        }
    }

    private IpaFrame nextFrame() {
        limitDuration();
        generator.read(samples);
        RtpPacket packet = new RtpPacket(
                RtpPacket.A_LAW,
                sequence & 0xffff,
                Integer.toUnsignedLong(timestamp),
                Integer.toUnsignedLong(source),
                codec.encode(samples));
        sequence++;
        timestamp += SpeechCodec.SAMPLES_PER_FRAME;
        while (acknowledgementsDue > 0) {
            acknowledgementsDue--;
            acknowledgeStop();
        }
        if (generator.isIdle()) {
            timers.cancel(patience);
        }
        return new IpaFrame(IpaFrame.SPEECH, packet.encode());
    }

    private void limitDuration() {
        boolean isHeld = keys.size() == 1 && !keys.getFirst().isReleased;
        heldFrames = isHeld ? heldFrames + 1 : 0;
        if (heldFrames > LONGEST_FRAMES) {
            keys.getFirst().isReleased = true;
            generator.release();
        }
    }

    private void toneLeft() {
        if (keys.remove().awaitsAcknowledgement) {
            acknowledgementsDue++;
        }
    }

    private void acknowledgeStop() {
        leg.link().send(new CallControl.StopDtmfAcknowledge(leg.transaction()));
    }
}
