package simgsm.speech;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** Writes 8 kHz, 16-bit WAV files, at once or block by block. */
public final class WavWriter implements Closeable {
    private static final int HEADER_OCTETS = 44;
    /** Most octets of samples: the limit of the header's 32-bit lengths. */
    private static final long MOST_DATA_OCTETS = 0xFFFF_FFFFL - HEADER_OCTETS;

    private final FileChannel file;
    private final int channels;
    private long octets;

    /** Begins a file of unknown length; {@link #commit} and closing write the length into the header. */
    public WavWriter(Path path, int channels) throws IOException {
        if (channels < 1 || channels > 2) {
            throw new IllegalArgumentException(channels + " channels (expected 1 or 2)");
        }
        this.channels = channels;
        file = FileChannel.open(
                path, StandardOpenOption.CREATE, StandardOpenOption.WRITE, StandardOpenOption.TRUNCATE_EXISTING);
        writeFully(header(channels, 0));
    }

    /** Writes a complete mono file. */
    public static void write(Path path, short[] samples) throws IOException {
        byte[] all = new byte[HEADER_OCTETS + 2 * samples.length];
        ByteBuffer buffer = ByteBuffer.wrap(all).put(header(1, 2L * samples.length));
        buffer.order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().put(samples);
        Files.write(path, all);
    }

    /** Appends samples. @param samples channels alternating */
    public void write(short[] samples) throws IOException {
        if (octets + 2L * samples.length > MOST_DATA_OCTETS) {
            throw new IOException("a WAV file holds no more than 4 GiB");
        }
        ByteBuffer buffer = ByteBuffer.allocate(2 * samples.length).order(ByteOrder.LITTLE_ENDIAN);
        buffer.asShortBuffer().put(samples);
        writeFully(buffer);
        octets += 2L * samples.length;
    }

    /** Writes the current length into the header, after which the file is valid. */
    public void commit() throws IOException {
        ByteBuffer header = header(channels, octets);
        while (header.hasRemaining()) {
            file.write(header, header.position());
        }
    }

    @Override
    public void close() throws IOException {
        try (file) {
            commit();
        }
    }

    private void writeFully(ByteBuffer buffer) throws IOException {
        while (buffer.hasRemaining()) {
            file.write(buffer);
        }
    }

    private static ByteBuffer header(int channels, long dataOctets) {
        int data = (int) Math.min(dataOctets, MOST_DATA_OCTETS);
        ByteBuffer header = ByteBuffer.allocate(HEADER_OCTETS).order(ByteOrder.LITTLE_ENDIAN);
        header.put("RIFF".getBytes(StandardCharsets.US_ASCII)).putInt(data + HEADER_OCTETS - 8);
        header.put("WAVEfmt ".getBytes(StandardCharsets.US_ASCII)).putInt(16);
        header.putShort((short) 1).putShort((short) channels);
        header.putInt(SpeechCodec.SAMPLES_PER_SECOND).putInt(SpeechCodec.SAMPLES_PER_SECOND * 2 * channels);
        header.putShort((short) (2 * channels)).putShort((short) 16);
        header.put("data".getBytes(StandardCharsets.US_ASCII)).putInt(data);
        return header.flip();
    }
}
