package blackbox.fuzz;

import java.nio.ByteBuffer;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import simgsm.abis.CcmCodec;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.abis.MgcpMessage;
import simgsm.abis.RslMessage;
import simgsm.abis.RtpPacket;
import simgsm.air.Direction;
import simgsm.air.Layer3Codec;
import simgsm.air.ProtocolViolation;
import simgsm.octets.OctetString;
import simgsm.octets.Octets;
import simgsm.speech.SpeechCodec;

/**
 * Mutated frames, recorded ones and messages of random elements, through the framer and all decoders. Each must give a message or a {@link ProtocolViolation}; a message
 * must have a text, and must be the same after encoding and decoding. The same seed gives the same mutations.
 */
final class CodecFuzz {
    /** One frame in 64 is mutated with its header; the framer may then skip frames until it is replaced. */
    private static final int FRAMES_PER_HEADER_MUTATION = 64;

    private static final int RECORDED_FRAMES_PER_RANDOM_MESSAGE = 8;

    private final List<RecordedFrames.Sample> traffic = RecordedFrames.read();
    private final SplittableRandom random;
    private final Mutator mutator;
    private final Map<Integer, SpeechCodec> speechCodecs = Map.of(
            RtpPacket.A_LAW, SpeechCodec.Kind.A_LAW.open(),
            RtpPacket.GSM_FULL_RATE, SpeechCodec.Kind.GSM_FULL_RATE.open());
    private final SignallingRoundTrip signalling = new SignallingRoundTrip();
    private IpaFramer framer = new IpaFramer();
    private long frames;
    private long read;
    private long refused;

    CodecFuzz(long seed) {
        random = new SplittableRandom(seed);
        mutator = new Mutator(random);
    }

    /** Mutated frames so far. */
    long frames() {
        return frames;
    }

    /** Frames that were decoded. */
    long read() {
        return read;
    }

    /** Frames that were refused with a violation. */
    long refused() {
        return refused;
    }

    /** Mutates and decodes one frame. @throws AssertionError for any other exception than a violation */
    void step() {
        RecordedFrames.Sample sample = any();
        byte[] payload = random.nextInt(8) == 0
                ? mutator.splice(sample.frame().payload(), any().frame().payload())
                : sample.frame().payload();
        payload = mutator.mutate(payload, IpaFrame.MAX_PAYLOAD);
        byte[] wire = IpaFramer.encode(new IpaFrame(sample.frame().stream(), payload));
        if (random.nextInt(FRAMES_PER_HEADER_MUTATION) == 0) {
            wire = mutator.mutate(wire, wire.length + IpaFrame.MAX_PAYLOAD);
        }
        frames++;
        try {
            cut(wire, sample.direction());
        } catch (RuntimeException e) {
            throw new AssertionError(
                    "frame " + frames + ": " + e + " from " + HexFormat.of().formatHex(wire), e);
        }
    }

    /** A recorded frame, or one with a layer-3 message of random elements. */
    private RecordedFrames.Sample any() {
        if (random.nextInt(RECORDED_FRAMES_PER_RANDOM_MESSAGE) == 0) {
            boolean isUp = random.nextBoolean();
            Direction direction = isUp ? Direction.UPLINK : Direction.DOWNLINK;
            OctetString layer3 = OctetString.of(Layer3Codec.random(random, direction));
            RslMessage message = isUp
                    ? new RslMessage.DataIndication(RslMessage.Sapi.SIGNALLING, layer3)
                    : new RslMessage.DataRequest(RslMessage.Sapi.SIGNALLING, layer3);
            return new RecordedFrames.Sample(direction, new IpaFrame(IpaFrame.RSL, message.encode()));
        }
        return traffic.get(random.nextInt(traffic.size()));
    }

    /** The frame in two pieces, as TCP may deliver it. */
    private void cut(byte[] wire, Direction direction) {
        int middle = random.nextInt(wire.length + 1);
        try {
            take(Octets.range(wire, 0, middle), direction);
            take(Octets.range(wire, middle, wire.length), direction);
        } catch (ProtocolViolation violation) {
            refused++;
            framer = new IpaFramer();
        }
    }

    private void take(byte[] piece, Direction direction) throws ProtocolViolation {
        framer.accept(ByteBuffer.wrap(piece));
        for (Optional<IpaFrame> frame = framer.next(); frame.isPresent(); frame = framer.next()) {
            try {
                decode(frame.get(), direction);
                read++;
            } catch (ProtocolViolation violation) {
                refused++;
            }
        }
    }

    private void decode(IpaFrame frame, Direction direction) throws ProtocolViolation {
        switch (frame.stream()) {
            case IpaFrame.RSL -> signalling.check(frame.payload(), direction);
            case IpaFrame.CCM -> CcmCodec.encode(CcmCodec.decode(frame.payload()));
            case IpaFrame.MGCP -> MgcpMessage.decode(frame.payload()).encode();
            case IpaFrame.SPEECH -> speech(RtpPacket.decode(frame.payload()));
            default -> {}
        }
    }

    private void speech(RtpPacket packet) throws ProtocolViolation {
        RtpPacket.decode(packet.encode());
        speechCodecs.get(packet.payloadType()).decode(packet.payload());
    }
}
