package simgsm.tools.audio;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.ReadableByteChannel;

/** Samples that need no conversion: 8 kHz, 16 bit, mono, little-endian. */
final class UnconvertedSamples implements SampleSource {
    private final ReadableByteChannel file;
    private final ByteBuffer octets;
    /** Octets of sound in the file, those in the buffer excluded. */
    private long left;

    /**
     * @param octets buffer with the first octets of the file, positioned at the first sample; reused for the rest
     * @param dataOctets most octets of sound from that position on
     */
    UnconvertedSamples(ReadableByteChannel file, ByteBuffer octets, long dataOctets) {
        this.file = file;
        this.octets = octets.order(ByteOrder.LITTLE_ENDIAN);
        octets.limit(octets.position() + (int) Math.min(octets.remaining(), dataOctets));
        left = dataOctets - octets.remaining();
    }

    @Override
    public int read(short[] samples, int from, int to) throws IOException {
        int at = from;
        while (at < to && (octets.remaining() >= 2 || fill())) {
            int n = Math.min(to - at, octets.remaining() / 2);
            octets.asShortBuffer().get(samples, at, n);
            octets.position(octets.position() + 2 * n);
            at += n;
        }
        return at - from;
    }

    private boolean fill() throws IOException {
        octets.compact();
        octets.limit((int) Math.min(octets.capacity(), octets.position() + left));
        while (octets.position() < 2 && octets.hasRemaining()) {
            int n = file.read(octets);
            left = n < 0 ? 0 : left - n;
            if (n < 0) {
                break;
            }
        }
        octets.flip();
        return octets.remaining() >= 2;
    }

    @Override
    public double lookAheadSeconds() {
        return 0;
    }
}
