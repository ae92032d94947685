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
import java.nio.channels.ReadableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.UnsupportedAudioFileException;
import simgsm.speech.Resampler;
import simgsm.speech.SpeechCodec;

/**
 * A sound file read as speech: WAV and all formats of javax.sound, channels mixed to one, resampled to 8 kHz. The
 * file, possibly a pipe, is read in order and in constant memory.
 */
public final class SpeechFile implements Closeable {
    /** Octets per read; a WAV header must end within the first 64 KiB. */
    private static final int BUFFER_OCTETS = 1 << 16;

    private static final Path STANDARD_INPUT = Path.of("-");

    private final ReadableByteChannel file;
    private final Path path;
    private final SampleSource samples;
    /** End of the sound according to the header. */
    private long end;

    private SpeechFile(ReadableByteChannel file, Path path, Resampler.Slope slope) throws IOException {
        this.file = file;
        this.path = path;
        samples = samples(slope);
    }

    /**
     * Opens a file; {@code -} is the standard input.
     *
     * @throws NotAudioException if the file exists but is no audio
     */
    public static SpeechFile open(Path path) throws IOException {
        return open(path, Resampler.Slope.STEEP);
    }

    /**
     * Opens a file for a DTMF receiver: the resampling filter looks ahead by less than 1 ms, and attenuates frequencies
     * above the DTMF tones.
     *
     * @throws NotAudioException if the file exists but is no audio
     */
    public static SpeechFile openForKeys(Path path) throws IOException {
        return open(path, Resampler.Slope.GENTLE);
    }

    private static SpeechFile open(Path path, Resampler.Slope slope) throws IOException {
        ReadableByteChannel file = path.equals(STANDARD_INPUT)
                ? Channels.newChannel(System.in)
                : FileChannel.open(path, StandardOpenOption.READ);
        if (Files.isDirectory(path)) {
            file.close();
            throw new NotAudioException(path + ": a folder, no audio", null);
        }
        try {
            return new SpeechFile(file, path, slope);
        } catch (IOException e) {
            file.close();
            throw e;
        }
    }

    private SampleSource samples(Resampler.Slope slope) throws IOException {
        ByteBuffer head = ByteBuffer.allocateDirect(BUFFER_OCTETS);
        while (head.hasRemaining() && file.read(head) >= 0) {}
        head.flip();
        Optional<WavHeader> wav = WavHeader.in(head);
        try {
            if (GsmSamples.begin(head)) {
                return new GsmSamples(path, rest(head, file), false, Long.MAX_VALUE);
            }
            if (wav.isEmpty()) {
                return foreign(rest(head, file), slope);
            }
            AudioFormat format = wav.get().format();
            head.position(wav.get().dataAt());
            end = wav.get().dataOctets() == Long.MAX_VALUE
                    ? 0
                    : wav.get().dataAt() + wav.get().dataOctets();
            if (format.getEncoding().equals(WavHeader.GSM)) {
                return new GsmSamples(path, rest(head, file), true, wav.get().dataOctets());
            }
            return isSpeech(format)
                    ? new UnconvertedSamples(file, head, wav.get().dataOctets())
                    : new ConvertedSamples(rest(head, file), format, wav.get().dataOctets(), slope);
        } catch (NotAudioException e) {
            throw new NotAudioException(path + ": " + e.getMessage(), e);
        } catch (UnsupportedAudioFileException | RuntimeException e) {
            // The JDK's readers throw unchecked exceptions for some damaged headers.
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

    /** Audio of other formats, read by the JDK. */
    private static SampleSource foreign(InputStream octets, Resampler.Slope slope)
            throws IOException, UnsupportedAudioFileException {
        AudioInputStream stream = AudioSystem.getAudioInputStream(new BufferedInputStream(octets, BUFFER_OCTETS));
        return new ConvertedSamples(stream, stream.getFormat(), Long.MAX_VALUE, slope);
    }

    private static InputStream rest(ByteBuffer head, ReadableByteChannel file) {
        byte[] read = new byte[head.remaining()];
        head.get(read);
        return new SequenceInputStream(new ByteArrayInputStream(read), Channels.newInputStream(file));
    }

    /** Octets of sound promised by the header but missing in the file; 0 for a pipe. */
    public long missingOctets() throws IOException {
        return Files.isRegularFile(path) ? Math.max(0, end - Files.size(path)) : 0;
    }

    /** Look-ahead of the resampling filter; 0 without resampling. */
    public double lookAheadMillis() {
        return samples.lookAheadSeconds() * 1000;
    }

    /** Fills the block. @return the number of samples, -1 at the end */
    public int read(short[] block) throws IOException {
        return read(block, 0, block.length);
    }

    /** Fills {@code block[from..to)}. @return the number of samples, -1 at the end */
    public int read(short[] block, int from, int to) throws IOException {
        int n = samples.read(block, from, to);
        return n == 0 && to > from ? -1 : n;
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
