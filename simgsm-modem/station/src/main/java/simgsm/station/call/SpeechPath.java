package simgsm.station.call;

import java.lang.System.Logger.Level;
import java.util.Map;
import java.util.Optional;
import simgsm.abis.IpaFrame;
import simgsm.abis.RtpPacket;
import simgsm.air.ProtocolViolation;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simgsm.speech.SubstitutingDecoder;
import simgsm.station.context.StationContext;
import simgsm.station.context.StationEvent;
import simgsm.station.context.StationTimer;

/** The speech of a call: sends a frame every 20 ms of the station's time and orders received frames by RTP. */
public final class SpeechPath {
    /** Frames of a stall up to this length are sent late; those of a longer one are dropped. */
    private static final long MAX_CATCH_UP_NANOS = 2_000_000_000L;

    /** 1 s; a larger jump of the sequence numbers is a new stream, not a loss. */
    private static final int MAX_LOSS_FRAMES = 50;

    /** 10 s, counted in sent frames, so that a stall of the owner does not count. */
    private static final int MAX_SILENCE_FRAMES = 500;

    private static final int SEQUENCE_MASK = 0xffff;
    private static final long TIMESTAMP_MASK = 0xffff_ffffL;

    private final StationContext context;
    private final SpeechSource source;
    private final CallAudioListener recorder;
    private AddedSpeech added = AddedSpeech.NONE;
    private SpeechCodec.Kind codec;
    private SpeechCodec.Kind nextCodec;
    /** Opened for each call, like the decoders: a codec may have a state. */
    private SpeechCodec coder;
    /** By payload type. */
    private Map<Integer, SubstitutingDecoder> decoders = Map.of();

    private final long synchronizationSource;
    private boolean active;
    private Runnable farEndSilent;
    private long nextFrameNanos;
    private int sequence;
    private long timestamp;
    private boolean heard;
    private int expectedSequence;
    private long heardSource;
    private int framesSinceHeard;
    /** Null until the first frame of the call. */
    private SpeechCodec.Kind heardCodec;

    /** @param recorder receives the speech of all calls */
    public SpeechPath(
            StationContext context,
            SpeechCodec.Kind codec,
            CallAudioListener recorder,
            SpeechSource source,
            int synchronizationSource) {
        this.context = context;
        this.codec = codec;
        nextCodec = codec;
        this.recorder = recorder;
        this.source = source;
        this.synchronizationSource = synchronizationSource & TIMESTAMP_MASK;
    }

    /** Sets the speech that is added to the source's. */
    public void setAdded(AddedSpeech speech) {
        added = speech;
    }

    /** Sets the codec of later calls. */
    public void setCodec(SpeechCodec.Kind next) {
        nextCodec = next;
        codec = active ? codec : next;
    }

    /** The codec of the current call, or of the next. */
    public SpeechCodec.Kind codec() {
        return codec;
    }

    /** The codec of the newest frame received in the current call. */
    public Optional<SpeechCodec.Kind> heardCodec() {
        return Optional.ofNullable(heardCodec);
    }

    /**
     * Opens the path; if it is open, only the wait for received speech restarts.
     *
     * @param farEndSilent runs every 20 ms while no frame has been received for 10 s
     */
    void start(Runnable farEndSilent) {
        this.farEndSilent = farEndSilent;
        framesSinceHeard = 0;
        if (active) {
            return;
        }
        active = true;
        heard = false;
        codec = nextCodec;
        coder = codec.open();
        decoders = Map.of(
                RtpPacket.A_LAW, new SubstitutingDecoder(SpeechCodec.Kind.A_LAW),
                RtpPacket.GSM_FULL_RATE, new SubstitutingDecoder(SpeechCodec.Kind.GSM_FULL_RATE));
        recorder.callBegan();
        nextFrameNanos = context.timers().nowNanos();
        scheduleFrame();
    }

    void stop() {
        if (active) {
            recorder.callEnded();
        }
        active = false;
        codec = nextCodec;
        heardCodec = null;
        context.timers().stop(StationTimer.SPEECH);
    }

    private void scheduleFrame() {
        context.timers()
                .start(StationTimer.SPEECH, nextFrameNanos - context.timers().nowNanos(), this::frameDue);
    }

    private void frameDue() {
        for (int due = added.framesDue(); due > 0 && active; due--) {
            send();
        }
        nextFrameNanos += StationTimer.SPEECH.nanos();
        if (context.timers().nowNanos() - nextFrameNanos > MAX_CATCH_UP_NANOS) {
            nextFrameNanos = context.timers().nowNanos() + StationTimer.SPEECH.nanos();
        }
        if (active) {
            scheduleFrame();
        }
        if (active && framesSinceHeard >= MAX_SILENCE_FRAMES) {
            farEndSilent.run();
        }
    }

    private void send() {
        short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
        source.read(frame);
        if (!active) {
            return;
        }
        frame = added.addTo(frame);
        recorder.sent(frame);
        framesSinceHeard++;
        sequence = sequence + Math.min(MAX_LOSS_FRAMES, source.framesDropped()) & SEQUENCE_MASK;
        RtpPacket packet =
                new RtpPacket(codec.payloadType(), sequence, timestamp, synchronizationSource, coder.encode(frame));
        sequence = sequence + 1 & SEQUENCE_MASK;
        timestamp = timestamp + SpeechCodec.SAMPLES_PER_FRAME & TIMESTAMP_MASK;
        context.radio().send(IpaFrame.SPEECH, packet.encode());
    }

    public void arrived(byte[] payload) {
        if (!active) {
            return;
        }
        try {
            arrived(RtpPacket.decode(payload));
        } catch (ProtocolViolation e) {
            context.log().trace(Level.WARNING, "speech frame dropped: {0}", e.getMessage());
        }
    }

    private void arrived(RtpPacket packet) {
        framesSinceHeard = 0;
        int lost = framesLostBefore(packet);
        if (lost < 0) {
            return;
        }
        SubstitutingDecoder decoder = decoders.get(packet.payloadType());
        if (lost > 0) {
            context.events().add(new StationEvent.SpeechLost(lost));
        }
        for (int i = 0; i < lost; i++) {
            report(decoder.substitute());
        }
        heardCodec = decoder.kind();
        report(decoder.decode(packet.payload()));
        heard = true;
        heardSource = packet.source();
        expectedSequence = packet.sequence() + 1 & SEQUENCE_MASK;
    }

    /** The number of frames missing before this one; negative if it is late. */
    private int framesLostBefore(RtpPacket packet) {
        if (!heard || packet.source() != heardSource) {
            return 0;
        }
        int ahead = (short) (packet.sequence() - expectedSequence);
        return Math.abs(ahead) > MAX_LOSS_FRAMES ? 0 : ahead;
    }

    private void report(short[] samples) {
        recorder.received(samples);
        context.events().add(new StationEvent.SpeechReceived(samples));
    }
}
