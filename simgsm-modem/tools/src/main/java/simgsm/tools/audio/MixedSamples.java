package simgsm.tools.audio;

import java.io.IOException;
import java.io.InputStream;
import javax.sound.sampled.AudioFormat;
import simgsm.speech.Resampler;
import simgsm.speech.SpeechCodec;

/** Samples of any form, their channels mixed to one and resampled to 8 kHz, in constant memory. */
final class MixedSamples implements Samples {
    private static final int BLOCK_FRAMES = 2048;
    /** At lower rates a gentle slope would reach the keys' highest tone. */
    private static final int LEAST_GENTLE = 5000;

    private final InputStream stream;
    private final PcmFormat format;
    private final Resampler resampler;
    private final byte[] octets;
    private final float[] mixed = new float[BLOCK_FRAMES];
    private int held;
    private long left;
    private boolean atEnd;

    /**
     * @param stream its next octet is the first sample's first
     * @param dataOctets how many octets of sound there are at most
     */
    MixedSamples(InputStream stream, AudioFormat form, long dataOctets, Resampler.Slope slope)
            throws NotAudioException {
        this.stream = stream;
        this.format = PcmFormat.of(form);
        this.octets = new byte[BLOCK_FRAMES * format.octetsPerFrame()];
        this.left = dataOctets;
        int rate = Math.round(form.getSampleRate());
        this.resampler = rate == SpeechCodec.SAMPLES_PER_SECOND
                ? null
                : new Resampler(
                        rate, SpeechCodec.SAMPLES_PER_SECOND, rate < LEAST_GENTLE ? Resampler.Slope.STEEP : slope);
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

    /** Takes the next block from the file. @return whether anything came of it */
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
