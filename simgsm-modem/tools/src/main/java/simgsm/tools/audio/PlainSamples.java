package simgsm.tools.audio;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.ReadableByteChannel;

/** Samples that are speech as they stand (8 kHz, 16 bit, mono, little endian): copied, never looked at. */
final class PlainSamples implements Samples {
    private final ReadableByteChannel file;
    private final ByteBuffer octets;
    /** Octets of sound that are still in the file and not in the buffer. */
    private long left;

    /**
     * @param octets what has been read already, the first sample at its position; taken over, and filled again from
     *     {@code file}
     * @param dataOctets how many octets of sound there are from there on at most
     */
    PlainSamples(ReadableByteChannel file, ByteBuffer octets, long dataOctets) {
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

    /** @return whether there is a sample now */
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
