package simgsm.audio;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.UnsupportedAudioFileException;

/** Sound files for a call. */
public final class SoundFile {
    private static final int SAMPLES_PER_SECOND = 8_000;
    private static final int BITS = 16;
    private static final int OCTETS = 2;
    /** Ten minutes. */
    private static final int MAX_SAMPLES = 600 * SAMPLES_PER_SECOND;

    private SoundFile() {}

    /**
     * Reads a WAV, AU or AIFF file of 8 kHz, 16 bit, mono.
     *
     * @throws IOException naming the expected format
     */
    public static short[] read(Path file) throws IOException {
        if (!Files.exists(file)) {
            throw new NoSuchFileException("no such file");
        }
        try (AudioInputStream in = AudioSystem.getAudioInputStream(file.toFile())) {
            AudioFormat format = in.getFormat();
            if (!format.getEncoding().equals(AudioFormat.Encoding.PCM_SIGNED)
                    || format.getSampleRate() != SAMPLES_PER_SECOND
                    || format.getSampleSizeInBits() != BITS
                    || format.getChannels() != 1) {
                throw new IOException("expected 8 kHz, 16 bit, mono, found " + format);
            }
            byte[] octets = in.readNBytes(OCTETS * MAX_SAMPLES + 1);
            if (octets.length > OCTETS * MAX_SAMPLES) {
                throw new IOException("expected at most ten minutes");
            }
            short[] samples = new short[octets.length / OCTETS];
            if (samples.length == 0) {
                throw new IOException("expected sound, found no sample");
            }
            ByteBuffer.wrap(octets)
                    .order(format.isBigEndian() ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN)
                    .asShortBuffer()
                    .get(samples);
            return samples;
        } catch (UnsupportedAudioFileException e) {
            throw new IOException("no audio that can be read", e);
        }
    }
}
