package simgsm.tools.audio;

import java.io.IOException;
import java.io.InputStream;
import javax.sound.sampled.AudioFormat;
import simgsm.speech.Resampler;
import simgsm.speech.SpeechCodec;

/** Samples of any format, their channels mixed to one and resampled to 8 kHz, in constant memory. */
final class ConvertedSamples implements SampleSource {
    private static final int BLOCK_FRAMES = 2048;
    /** Least rate, Hz, for the gentle slope: below it the filter would attenuate 1633 Hz, the highest DTMF tone. */
    private static final int LEAST_GENTLE_HZ = 5000;

    private final InputStream stream;
    private final SampleFormat format;
    private final Resampler resampler;
    private final byte[] octets;
    private final float[] mixed = new float[BLOCK_FRAMES];
    private int held;
    private long left;
    private boolean atEnd;

    /**
     * @param stream positioned at the first sample
     * @param dataOctets most octets of sound
     */
    ConvertedSamples(InputStream stream, AudioFormat audioFormat, long dataOctets, Resampler.Slope slope)
            throws NotAudioException {
        this.stream = stream;
        this.format = SampleFormat.of(audioFormat);
        this.octets = new byte[BLOCK_FRAMES * format.octetsPerFrame()];
        this.left = dataOctets;
        int rate = Math.round(audioFormat.getSampleRate());
        this.resampler = rate == SpeechCodec.SAMPLES_PER_SECOND
                ? null
                : new Resampler(
                        rate, SpeechCodec.SAMPLES_PER_SECOND, rate < LEAST_GENTLE_HZ ? Resampler.Slope.STEEP : slope);
    }

    @Override
    public int read(short[] samples, int from, int to) throws IOException {
        int at = from;
        while (at < to) {
            int written = resampler == null ? copy(samples, at, to) : resampler.read(samples, at, to);
            at += written;
            if (written == 0 && !fill()) {
                break;
            }
        }
        return at - from;
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

    /** Reads the next block of the file. @return false at the end */
    private boolean fill() throws IOException {
        if (atEnd) {
            return false;
        }
        int wanted = (int) Math.min(octets.length, left);
        int length = stream.readNBytes(octets, 0, wanted);
        left -= length;
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
    public double lookAheadSeconds() {
        return resampler == null ? 0 : resampler.lookAheadSeconds();
    }
}
