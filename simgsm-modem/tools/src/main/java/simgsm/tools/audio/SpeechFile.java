package simgsm.tools.audio;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.SequenceInputStream;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.Optional;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.UnsupportedAudioFileException;
import simgsm.speech.Resampler;
import simgsm.speech.SpeechCodec;

/**
 * A sound file read as speech: WAV, and whatever else javax.sound reads, its channels mixed to one, resampled to 8 kHz.
 * Read front to back, in constant memory, so that a pipe will do for a file.
 */
public final class SpeechFile implements Closeable {
    /** Read at a time; the head of a WAV file is looked for in so many octets. */
    private static final int BUFFER_OCTETS = 1 << 16;

    private final FileChannel file;
    private final Samples samples;

    private SpeechFile(FileChannel file, Samples samples) {
        this.file = file;
        this.samples = samples;
    }

    /** @throws NotAudioException when the file is there but is no audio */
    public static SpeechFile open(Path path) throws IOException {
        return open(path, Resampler.Slope.STEEP);
    }

    /**
     * To listen for keys, as {@link #open(Path)} but sooner: where it resamples it looks ahead by well under a millisecond,
     * and what lies above the keys' tones comes through less well.
     *
     * @throws NotAudioException when the file is there but is no audio
     */
    public static SpeechFile openForKeys(Path path) throws IOException {
        return open(path, Resampler.Slope.GENTLE);
    }

    private static SpeechFile open(Path path, Resampler.Slope slope) throws IOException {
        FileChannel file = FileChannel.open(path, StandardOpenOption.READ);
        if (Files.isDirectory(path)) {
            file.close();
            throw new NotAudioException(path + ": a folder, no audio", null);
        }
        try {
            return new SpeechFile(file, samples(file, path, slope));
        } catch (IOException e) {
            file.close();
            throw e;
        }
    }

    private static Samples samples(FileChannel file, Path path, Resampler.Slope slope) throws IOException {
        ByteBuffer head = ByteBuffer.allocateDirect(BUFFER_OCTETS);
        while (head.hasRemaining() && file.read(head) >= 0) {}
        head.flip();
        Optional<WavHeader> wav = WavHeader.in(head);
        try {
            if (wav.isEmpty()) {
                return foreign(rest(head, file), slope);
            }
            AudioFormat format = wav.get().format();
            head.position(wav.get().dataAt());
            return isSpeech(format)
                    ? new PlainSamples(file, head, wav.get().dataOctets())
                    : new MixedSamples(rest(head, file), format, wav.get().dataOctets(), slope);
        } catch (NotAudioException e) {
            throw new NotAudioException(path + ": " + e.getMessage(), e);
        } catch (UnsupportedAudioFileException | RuntimeException e) {
            // The JDK's readers answer some damaged headers with unchecked exceptions.
            throw new NotAudioException(path + ": no audio that can be read", e);
        } catch (IOException e) {
            throw new NotAudioException(path + ": damaged audio", e);
        }
    }

    private static boolean isSpeech(AudioFormat format) {
        return format.getEncoding().equals(AudioFormat.Encoding.PCM_SIGNED)
                && format.getSampleRate() == SpeechCodec.SAMPLES_PER_SECOND
                && format.getChannels() == 1
                && format.getFrameSize() == 2;
    }

    /** Audio of a kind that only the JDK knows. */
    private static Samples foreign(InputStream octets, Resampler.Slope slope)
            throws IOException, UnsupportedAudioFileException {
        AudioInputStream stream = AudioSystem.getAudioInputStream(new BufferedInputStream(octets, BUFFER_OCTETS));
        return new MixedSamples(stream, stream.getFormat(), Long.MAX_VALUE, slope);
    }

    private static InputStream rest(ByteBuffer head, FileChannel file) {
        byte[] read = new byte[head.remaining()];
        head.get(read);
        return new SequenceInputStream(new ByteArrayInputStream(read), Channels.newInputStream(file));
    }

    /** The whole file. */
    public static short[] readAll(Path path) throws IOException {
        try (SpeechFile file = open(path)) {
            short[] all = new short[1 << 14];
            int length = 0;
            for (int n; (n = file.read(all, length, all.length)) >= 0; length += n) {
                if (length + n == all.length) {
                    all = Arrays.copyOf(all, 2 * all.length);
                }
            }
            return Arrays.copyOf(all, length);
        }
    }

    /** How much later a sample is known than it would be in an 8 kHz file, for the resampling filter looks ahead. */
    public double lookAheadMillis() {
        return samples.lookAheadSeconds() * 1000;
    }

    public int read(short[] block) throws IOException {
        return read(block, 0, block.length);
    }

    /** Fills {@code block[from..to)} as far as there is sound. @return how many, -1 at the end */
    public int read(short[] block, int from, int to) throws IOException {
        int n = samples.read(block, from, to);
        return n == 0 && to > from ? -1 : n;
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
