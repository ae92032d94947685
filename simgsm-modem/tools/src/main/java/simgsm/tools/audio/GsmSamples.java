package simgsm.tools.audio;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import simgsm.speech.SpeechCodec;

/** GSM 06.10 at 8 kHz: frames of 33 octets, or two frames per block of 65 octets in WAV files. */
final class GsmSamples implements SampleSource {
    static final int FRAME_OCTETS = SpeechCodec.Kind.GSM_FULL_RATE.octetsPerFrame();
    static final int WAV_BLOCK_OCTETS = 65;

    private final SpeechCodec codec = SpeechCodec.Kind.GSM_FULL_RATE.open();
    private final Path path;
    private final InputStream stream;
    private final boolean isWav;
    private short[] decoded = {};
    private int used;
    private long left;

    /** @param dataOctets most octets of sound */
    GsmSamples(Path path, InputStream stream, boolean isWav, long dataOctets) {
        this.path = path;
        this.stream = stream;
        this.isWav = isWav;
        left = dataOctets;
    }

    /** True if the octets are frames of 33 octets, each with its signature. */
    static boolean begin(ByteBuffer head) {
        boolean frames = head.remaining() >= FRAME_OCTETS;
        for (int at = head.position(); frames && at < head.limit(); at += FRAME_OCTETS) {
            frames = (head.get(at) & 0xF0) == 0xD0;
        }
        return frames;
    }

    @Override
    public int read(short[] samples, int from, int to) throws IOException {
        int at = from;
        while (at < to && (used < decoded.length || fill())) {
            int n = Math.min(to - at, decoded.length - used);
            System.arraycopy(decoded, used, samples, at, n);
            used += n;
            at += n;
        }
        return at - from;
    }

    /** Decodes the next block. @return false at the end; an incomplete block is dropped */
    private boolean fill() throws IOException {
        int length = isWav ? WAV_BLOCK_OCTETS : FRAME_OCTETS;
        byte[] block = left < length ? new byte[0] : stream.readNBytes(length);
        if (block.length < length) {
            return false;
        }
        left -= length;
        used = 0;
        try {
            decoded = new short[(isWav ? 2 : 1) * SpeechCodec.SAMPLES_PER_FRAME];
            for (int i = 0; SpeechCodec.SAMPLES_PER_FRAME * i < decoded.length; i++) {
                short[] frame = codec.decode(isWav ? SpeechCodec.gsmFrameOfWav(block, i) : block);
                System.arraycopy(frame, 0, decoded, SpeechCodec.SAMPLES_PER_FRAME * i, frame.length);
            }
        } catch (IllegalArgumentException e) {
            throw new NotAudioException(path + ": damaged audio: " + e.getMessage(), e);
        }
        return true;
    }

    @Override
    public double lookAheadSeconds() {
        return 0;
    }
}
