package simgsm.tools.fuzz;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import simgsm.abis.CcmCodec;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;
import simgsm.abis.RtpPacket;
import simgsm.air.Direction;
import simgsm.air.ProtocolViolation;
import simgsm.speech.SpeechCodec;

/**
 * Spoilt frames through the framer and every decoder. Each gives a message or a {@link ProtocolViolation}; what is read can
 * be told in words, and be written and read again. The same seed spoils in the same way.
 */
public final class CodecFuzz {
    /** One frame in so many is spoilt with its header: what follows may be swallowed until the framer is replaced. */
    private static final int WIRE_DAMAGE_IN = 64;

    private final List<Traffic.Sample> traffic = Traffic.read();
    private final SplittableRandom random;
    private final Mutator mutator;
    private final Map<Integer, SpeechCodec> speechCodecs = Map.of(
            RtpPacket.A_LAW, SpeechCodec.Kind.A_LAW.open(),
            RtpPacket.GSM_FULL_RATE, SpeechCodec.Kind.GSM_FULL_RATE.open());
    private final SignallingCheck signalling = new SignallingCheck();
    private IpaFramer framer = new IpaFramer();
    private long frames;
    private long read;
    private long refused;

    public CodecFuzz(long seed) {
        random = new SplittableRandom(seed);
        mutator = new Mutator(random);
    }

    /** Spoilt frames so far. */
    public long frames() {
        return frames;
    }

    /** Of what the framer cut: what made sense all the same. */
    public long read() {
        return read;
    }

    /** What was refused with a violation. */
    public long refused() {
        return refused;
    }

    /** One spoilt frame. @throws Finding if it did what no frame may do */
    public void step() {
        Traffic.Sample sample = any();
        byte[] payload = random.nextInt(8) == 0
                ? mutator.spliced(sample.frame().payload(), any().frame().payload())
                : sample.frame().payload();
        payload = mutator.spoil(payload, IpaFrame.MAX_PAYLOAD);
        byte[] wire = IpaFramer.encode(new IpaFrame(sample.frame().stream(), payload));
        if (random.nextInt(WIRE_DAMAGE_IN) == 0) {
            wire = mutator.spoil(wire, wire.length + IpaFrame.MAX_PAYLOAD);
        }
        frames++;
        try {
            cut(wire, sample.direction());
        } catch (RuntimeException e) {
            throw new Finding(
                    "frame " + frames + ": " + e + " from " + HexFormat.of().formatHex(wire), e);
        }
    }

    private Traffic.Sample any() {
        return traffic.get(random.nextInt(traffic.size()));
    }

    /** Octets come in pieces, as TCP likes. */
    private void cut(byte[] wire, Direction direction) {
        int middle = random.nextInt(wire.length + 1);
        try {
            take(Arrays.copyOfRange(wire, 0, middle), direction);
            take(Arrays.copyOfRange(wire, middle, wire.length), direction);
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
            case IpaFrame.SPEECH ->
                RtpPacket.decode(RtpPacket.decode(frame.payload()).encode());
            default -> {}
        }
    }

    private void speech(RtpPacket packet) throws ProtocolViolation {
        RtpPacket.decode(packet.encode());
        speechCodecs.get(packet.payloadType()).decode(packet.payload());
    }
}
