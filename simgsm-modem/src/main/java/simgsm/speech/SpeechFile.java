package simgsm.speech;

import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.sound.sampled.AudioInputStream;
import javax.sound.sampled.AudioSystem;
import javax.sound.sampled.UnsupportedAudioFileException;

/**
 * A sound file read as speech: whatever javax.sound reads, its channels mixed to one, resampled to 8 kHz. Read front to
 * back, in constant memory.
 */
public final class SpeechFile implements Closeable {
    private static final int BLOCK_FRAMES = 2048;

    private final AudioInputStream stream;
    private final PcmFormat format;
    private final Resampler resampler;
    private final byte[] octets;
    private final float[] mixed = new float[BLOCK_FRAMES];
    private int held;
    private boolean atEnd;

    private SpeechFile(AudioInputStream stream) throws NotAudioException {
        this.stream = stream;
        this.format = PcmFormat.of(stream.getFormat());
        this.octets = new byte[BLOCK_FRAMES * format.octetsPerFrame()];
        int rate = Math.round(stream.getFormat().getSampleRate());
        this.resampler =
                rate == SpeechCodec.SAMPLES_PER_SECOND ? null : new Resampler(rate, SpeechCodec.SAMPLES_PER_SECOND);
    }

    /** @throws NotAudioException when the file is there but is no audio */
    public static SpeechFile open(Path path) throws IOException {
        InputStream file = new BufferedInputStream(Files.newInputStream(path), 1 << 16);
        try {
            return new SpeechFile(AudioSystem.getAudioInputStream(file));
        } catch (UnsupportedAudioFileException | RuntimeException e) {
            // The JDK's readers answer some damaged headers with unchecked exceptions.
            file.close();
            throw new NotAudioException(path + ": no audio that can be read", e);
        } catch (IOException e) {
            file.close();
            throw e instanceof NotAudioException
                    ? new NotAudioException(path + ": " + e.getMessage(), e)
                    : new NotAudioException(path + ": damaged audio", e);
        }
    }

    /** The whole file. */
    public static short[] readAll(Path path) throws IOException {
        try (SpeechFile file = open(path)) {
            short[] all = new short[1 << 14];
            int length = 0;
            for (int n; (n = file.read(all, length, all.length)) >= 0; length += n) {
                if (length + n == all.length) {
                    all = java.util.Arrays.copyOf(all, 2 * all.length);
                }
            }
            return java.util.Arrays.copyOf(all, length);
        }
    }

    /** How much later a sample is known than it would be in an 8 kHz file, for the resampling filter looks ahead. */
    public double lookAheadMillis() {
        return resampler == null ? 0 : resampler.lookAheadSeconds() * 1000;
    }

    public int read(short[] samples) throws IOException {
        return read(samples, 0, samples.length);
    }

    /** Fills {@code samples[from..to)} as far as there is sound. @return how many, -1 at the end */
    public int read(short[] samples, int from, int to) throws IOException {
        int at = from;
        while (at < to) {
            int written = resampler == null ? copy(samples, at, to) : resampler.read(samples, at, to);
            at += written;
            if (written == 0 && !fill()) {
                break;
            }
        }
        return at == from && to > from ? -1 : at - from;
    }

    private int copy(short[] samples, int from, int to) {
        int n = Math.min(held, to - from);
        for (int i = 0; i < n; i++) {
            samples[from + i] = Resampler.saturate(mixed[i]);
        }
        held -= n;
        System.arraycopy(mixed, n, mixed, 0, held);
        return n;
    }

    /** Takes the next block from the file. @return whether anything came of it */
    private boolean fill() throws IOException {
        if (atEnd) {
            return false;
        }
        int length = stream.readNBytes(octets, 0, octets.length);
        int frames = length / format.octetsPerFrame();
        format.mix(octets, frames, mixed);
        atEnd = length < octets.length;
        if (resampler == null) {
            held = frames;
            return frames > 0;
        }
        resampler.write(mixed, frames);
        if (atEnd) {
            resampler.end();
        }
        return true;
    }

    @Override
    public void close() throws IOException {
        stream.close();
    }
}
