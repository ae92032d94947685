package simgsm.tools.audio;

import javax.sound.sampled.AudioFormat;
import javax.sound.sampled.AudioFormat.Encoding;
import simgsm.speech.G711;

/** The format of a file's samples; converts them to the mean of the channels, as floats on the scale of 16 bits. */
final class SampleFormat {
    private enum Kind {
        SIGNED,
        UNSIGNED,
        FLOAT,
        A_LAW,
        MU_LAW
    }

    private static final int MOST_CHANNELS = 256;

    private final Kind kind;
    private final int channels;
    private final int octetsPerSample;
    private final boolean bigEndian;

    private SampleFormat(Kind kind, int channels, int octetsPerSample, boolean bigEndian) {
        this.kind = kind;
        this.channels = channels;
        this.octetsPerSample = octetsPerSample;
        this.bigEndian = bigEndian;
    }

    static SampleFormat of(AudioFormat format) throws NotAudioException {
        Kind kind = kind(format.getEncoding());
        int channels = format.getChannels();
        int octets = channels < 1 ? 0 : format.getFrameSize() / channels;
        boolean fits = kind != null
                && channels <= MOST_CHANNELS
                && (kind == Kind.FLOAT
                        ? octets == 4 || octets == 8
                        : kind == Kind.SIGNED || kind == Kind.UNSIGNED ? octets >= 1 && octets <= 4 : octets == 1);
        boolean rateFits = format.getSampleRate() >= 1000 && format.getSampleRate() <= 2_000_000;
        if (!fits || !rateFits) {
            throw new NotAudioException("audio in an unsupported format: " + format, null);
        }
        return new SampleFormat(kind, channels, octets, format.isBigEndian());
    }

    private static Kind kind(Encoding encoding) {
        if (encoding.equals(Encoding.PCM_SIGNED)) {
            return Kind.SIGNED;
        }
        if (encoding.equals(Encoding.PCM_UNSIGNED)) {
            return Kind.UNSIGNED;
        }
        if (encoding.equals(Encoding.PCM_FLOAT)) {
            return Kind.FLOAT;
        }
        if (encoding.equals(Encoding.ALAW)) {
            return Kind.A_LAW;
        }
        return encoding.equals(Encoding.ULAW) ? Kind.MU_LAW : null;
    }

    int octetsPerFrame() {
        return channels * octetsPerSample;
    }

    void mix(byte[] octets, int frames, float[] mixed) {
        if (kind == Kind.SIGNED && channels == 1 && octetsPerSample == 2 && !bigEndian) {
            for (int i = 0; i < frames; i++) {
                mixed[i] = (short) (octets[2 * i] & 0xFF | octets[2 * i + 1] << 8);
            }
            return;
        }
        for (int frame = 0; frame < frames; frame++) {
            double sum = 0;
            for (int channel = 0; channel < channels; channel++) {
                sum += sample(octets, (frame * channels + channel) * octetsPerSample);
            }
            mixed[frame] = (float) (sum / channels);
        }
    }

    private double sample(byte[] octets, int at) {
        switch (kind) {
            case A_LAW:
                return G711.A_LAW.expand(octets[at]);
            case MU_LAW:
                return G711.MU_LAW.expand(octets[at]);
            case FLOAT:
                long bits = word(octets, at);
                double value = octetsPerSample == 4 ? Float.intBitsToFloat((int) bits) : Double.longBitsToDouble(bits);
                return value >= -1e6 && value <= 1e6 ? 32768 * value : 0;
            default:
                // The sample's top bit at bit 63, then scaled down to 16 bits.
                long top = word(octets, at) << 64 - 8 * octetsPerSample;
                return (kind == Kind.SIGNED ? top : top ^ Long.MIN_VALUE) * 0x1p-48;
        }
    }

    private long word(byte[] octets, int at) {
        long word = 0;
        for (int i = 0; i < octetsPerSample; i++) {
            word = word << 8 | octets[bigEndian ? at + i : at + octetsPerSample - 1 - i] & 0xFF;
        }
        return word;
    }
}
