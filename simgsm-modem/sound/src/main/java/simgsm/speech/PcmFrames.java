package simgsm.speech;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Consumer;

/** Speech on a modem's second line: frames of 20 ms, 8 kHz, 16 bit, little-endian, in octets of any pieces. */
public final class PcmFrames {
    public static final int OCTETS = 2 * SpeechCodec.SAMPLES_PER_FRAME;

    private final ByteBuffer input = ByteBuffer.allocate(OCTETS).order(ByteOrder.LITTLE_ENDIAN);
    private final Consumer<short[]> frames;

    public PcmFrames(Consumer<short[]> frames) {
        this.frames = frames;
    }

    /** The next octets of the line. */
    public void accept(byte[] octets) {
        for (byte octet : octets) {
            input.put(octet);
            if (!input.hasRemaining()) {
                short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
                input.flip().asShortBuffer().get(frame);
                input.clear();
                frames.accept(frame);
            }
        }
    }

    /** Drops a partial frame at the beginning of a connection. */
    public void drop() {
        input.clear();
    }

    /** The octets of a frame. */
    public static byte[] octets(short[] frame) {
        ByteBuffer octets = ByteBuffer.allocate(2 * frame.length).order(ByteOrder.LITTLE_ENDIAN);
        octets.asShortBuffer().put(frame);
        return octets.array();
    }
}
