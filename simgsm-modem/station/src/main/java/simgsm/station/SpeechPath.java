package simgsm.station;

import java.lang.System.Logger.Level;
import java.util.Map;
import java.util.Optional;
import simgsm.abis.IpaFrame;
import simgsm.abis.RtpPacket;
import simgsm.air.ProtocolViolation;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;

/** The speech of an active call: a frame up every 20 ms by the station's own time, and what comes down in RTP's order. */
final class SpeechPath {
    /** A pause of the owner up to this long is made up for; after a longer one the sender goes on where it was. */
    private static final long LONGEST_CATCH_UP_NANOS = 200_000_000L;

    /** A larger jump of the sequence numbers is a new stream, not a loss: 1 s. */
    private static final int LONGEST_LOSS_FRAMES = 50;

    /** 10 s in frames of our own, so that a pause of the owner does not count; speech comes in silence, too. */
    static final int LONGEST_SILENCE_FRAMES = 500;

    private static final int SEQUENCE_MASK = 0xffff;
    private static final long TIMESTAMP_MASK = 0xffff_ffffL;

    private final StationParts parts;
    private final SpeechSource source;
    private final CallAudioListener listener;
    private final SpeechCodec.Kind codec;
    /** New for each call, as the decoders are, because a codec may remember. */
    private SpeechCodec coder;
    /** By payload type. */
    private Map<Integer, SpeechCodec> decoders = Map.of();

    private final long synchronizationSource;
    private Uplink uplink = Uplink.DISCONNECTED;
    private boolean active;
    private long nextFrameNanos;
    private int sequence;
    private long timestamp;
    private boolean heard;
    private int expectedSequence;
    private long heardSource;
    private int framesSinceHeard;
    /** Null until the present call's first frame. */
    private SpeechCodec.Kind heardCodec;

    SpeechPath(StationParts parts, StationOptions options, SpeechSource source, int synchronizationSource) {
        this.parts = parts;
        this.listener = options.listener();
        this.codec = options.codec();
        this.source = source;
        this.synchronizationSource = synchronizationSource & TIMESTAMP_MASK;
    }

    SpeechCodec.Kind codec() {
        return codec;
    }

    /** What the far end's newest frame was coded with, in the present call. */
    Optional<SpeechCodec.Kind> heardCodec() {
        return Optional.ofNullable(heardCodec);
    }

    void setUplink(Uplink newUplink) {
        uplink = newUplink;
    }

    /** Does nothing but begin to wait for speech anew where the path is open already. */
    void start() {
        framesSinceHeard = 0;
        if (active) {
            return;
        }
        active = true;
        heard = false;
        coder = codec.open();
        decoders = Map.of(
                RtpPacket.A_LAW, SpeechCodec.Kind.A_LAW.open(),
                RtpPacket.GSM_FULL_RATE, SpeechCodec.Kind.GSM_FULL_RATE.open());
        listener.callBegan();
        nextFrameNanos = parts.timers().nowNanos();
        parts.timers().startAt(StationTimer.SPEECH, nextFrameNanos);
    }

    void stop() {
        if (active) {
            listener.callEnded();
        }
        active = false;
        heardCodec = null;
        parts.timers().stop(StationTimer.SPEECH);
    }

    /** The next frame is due. */
    void frameDue() {
        if (!active) {
            return;
        }
        send();
        nextFrameNanos += StationTimer.SPEECH.nanos();
        if (parts.timers().nowNanos() - nextFrameNanos > LONGEST_CATCH_UP_NANOS) {
            nextFrameNanos = parts.timers().nowNanos() + StationTimer.SPEECH.nanos();
        }
        if (active) {
            parts.timers().startAt(StationTimer.SPEECH, nextFrameNanos);
        }
    }

    private void send() {
        short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
        source.read(frame);
        if (!active) {
            return;
        }
        listener.sent(frame);
        framesSinceHeard++;
        RtpPacket packet =
                new RtpPacket(codec.payloadType(), sequence, timestamp, synchronizationSource, coder.encode(frame));
        sequence = sequence + 1 & SEQUENCE_MASK;
        timestamp = timestamp + SpeechCodec.SAMPLES_PER_FRAME & TIMESTAMP_MASK;
        uplink.send(new IpaFrame(IpaFrame.SPEECH, packet.encode()));
    }

    /** Whether the far end has been silent for longer than any call is. */
    boolean isDead() {
        return active && framesSinceHeard >= LONGEST_SILENCE_FRAMES;
    }

    void arrived(byte[] payload) {
        if (!active) {
            return;
        }
        try {
            take(RtpPacket.decode(payload));
        } catch (ProtocolViolation e) {
            parts.log().trace(Level.WARNING, "speech frame dropped: {0}", e.getMessage());
        }
    }

    private void take(RtpPacket packet) {
        framesSinceHeard = 0;
        int lost = framesLostBefore(packet);
        if (lost < 0) {
            return;
        }
        for (int i = 0; i < lost; i++) {
            tell(new short[SpeechCodec.SAMPLES_PER_FRAME]);
        }
        SpeechCodec decoder = decoders.get(packet.payloadType());
        heardCodec = decoder.kind();
        tell(decoder.decode(packet.payload()));
        heard = true;
        heardSource = packet.source();
        expectedSequence = packet.sequence() + 1 & SEQUENCE_MASK;
    }

    /** How many frames are missing before this one; negative if its time has passed. */
    private int framesLostBefore(RtpPacket packet) {
        if (!heard || packet.source() != heardSource) {
            return 0;
        }
        int ahead = (short) (packet.sequence() - expectedSequence);
        return Math.abs(ahead) > LONGEST_LOSS_FRAMES ? 0 : ahead;
    }

    private void tell(short[] samples) {
        listener.received(samples);
        parts.notifications().add(listener -> listener.speechReceived(samples));
    }
}
