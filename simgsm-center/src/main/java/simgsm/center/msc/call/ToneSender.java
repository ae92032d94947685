package simgsm.center.msc.call;

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
import simgsm.dtmf.ToneShape;
import simgsm.speech.SpeechCodec;
import simgsm.timer.Timer;

/**
 * Converts the keys that the mobile of one leg signals to tones for the other party (TS 23.014). During a tone, and in the
 * pause after it, each speech frame of the mobile is replaced by a tone frame with the same RTP numbers; without a speech
 * frame within 40 ms the tone frame is sent with the next numbers. Tone frames are A-law for any codec of the mobile.
 *
 * <p>A tone lasts as long as the key is held, at least 70 ms and at most 30 s, and is followed by at least 65 ms of silence.
 * START DTMF is acknowledged at once, STOP DTMF after the tone.
 */
public final class ToneSender {
    /** Maximum of keys of a mobile that does not wait for acknowledgements, including the sounding one. */
    public static final int MAX_KEYS = 32;

    static final int LONGEST_FRAMES = 1_500;

    private static final long FRAME_NANOS = TimeUnit.MILLISECONDS.toNanos(20);
    /** Maximum wait for a speech frame of the mobile. */
    private static final long PATIENCE_NANOS = TimeUnit.MILLISECONDS.toNanos(40);

    private static final long NANOS_PER_SAMPLE = 125_000;
    /** The RTP source before the first speech frame of the mobile: "tone". */
    private static final int OWN_SOURCE = 0x746f6e65;

    /** A larger difference of sequence numbers, 1 s, means a new stream, not a late frame. */
    private static final int LONGEST_LEAD_FRAMES = 50;

    private final CallLeg leg;
    private final SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
    /** Tones without ramps, so that a tone begins and ends with its frames. */
    private final DtmfGenerator generator = new DtmfGenerator(ToneShape.STANDARD.withRamp(0), key -> toneLeft());
    /** Keys from START DTMF to the tone's end, the sounding one first. */
    private final Deque<SignalledKey> keys = new ArrayDeque<>();

    private final short[] samples = new short[SpeechCodec.SAMPLES_PER_FRAME];
    private int heldFrames;
    private int acknowledgementsDue;
    private Timer patience;

    // RTP numbers of the next frame.
    private int source = OWN_SOURCE;
    private int sequence;
    private int timestamp;
    /** True if tone frames were sent with numbers that the mobile's stream has not yet reached. */
    private boolean isAhead;

    private static final class SignalledKey {
        boolean isReleased;
        boolean awaitsAcknowledgement;
    }

    ToneSender(CallLeg leg) {
        this.leg = leg;
    }

    /** START DTMF. */
    void start(char key) {
        if (leg.listener() == null || !leg.speaks()) {
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
            keys.add(new SignalledKey());
            generator.press(DtmfKey.of(key));
            leg.link().send(new CallControl.StartDtmfAcknowledge(leg.transaction(), key));
        }
    }

    private void reject(Cause cause) {
        leg.link().send(new CallControl.StartDtmfReject(leg.transaction(), cause));
    }

    private void begin() {
        if (source == OWN_SOURCE) {
            timestamp = (int) (leg.link().timers().nowNanos() / NANOS_PER_SAMPLE);
        }
        waitFor(PATIENCE_NANOS);
    }

    /** STOP DTMF; acknowledged even if the key has already ended. */
    void stop() {
        if (keys.isEmpty() || keys.getLast().isReleased) {
            acknowledgeStop();
        } else {
            keys.getLast().isReleased = true;
            keys.getLast().awaitsAcknowledgement = true;
            generator.release();
        }
    }

    /** Ends the tones, because the leg passes no more speech. */
    void end() {
        generator.drop();
        keys.clear();
        leg.link().timers().cancel(patience);
    }

    /** The frame that replaces a speech frame of the mobile: itself, a tone frame, or null if it is late. */
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
        leg.link().timers().cancel(patience);
        patience = leg.link().timers().start(nanos, this::noSpeechInTime);
    }

    private void noSpeechInTime() {
        CallLeg listener = leg.listener();
        if (listener != null) {
            isAhead = true;
            waitFor(FRAME_NANOS);
            listener.link().access().sendSpeech(nextFrame());
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
            leg.link().timers().cancel(patience);
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
