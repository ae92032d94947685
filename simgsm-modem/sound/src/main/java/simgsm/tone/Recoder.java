package simgsm.tone;

import java.util.Arrays;
import java.util.Optional;
import simgsm.speech.SpeechCodec;

/** Encodes and decodes sound by a codec in frames of 20 ms. Owned by one thread. */
public final class Recoder {
    private Optional<SpeechCodec.Kind> kind = Optional.empty();
    private SpeechCodec coder;
    private SpeechCodec decoder;
    /** The incomplete frame. */
    private short[] rest = new short[0];

    /** Leaves the sound unchanged until a codec is set. */
    public Recoder() {}

    /** @param newKind empty to leave the sound unchanged */
    public void set(Optional<SpeechCodec.Kind> newKind) {
        if (!newKind.equals(kind)) {
            kind = newKind;
            clear();
        }
    }

    void clear() {
        coder = kind.map(SpeechCodec.Kind::open).orElse(null);
        decoder = kind.map(SpeechCodec.Kind::open).orElse(null);
        rest = new short[0];
    }

    /** Accepts the next stretch. @return the completed frames, none or several */
    public short[] recoded(short[] samples) {
        if (kind.isEmpty()) {
            return samples;
        }
        short[] all = Arrays.copyOf(rest, rest.length + samples.length);
        System.arraycopy(samples, 0, all, rest.length, samples.length);
        int whole = all.length - all.length % SpeechCodec.SAMPLES_PER_FRAME;
        short[] result = new short[whole];
        for (int at = 0; at < whole; at += SpeechCodec.SAMPLES_PER_FRAME) {
            short[] frame = Arrays.copyOfRange(all, at, at + SpeechCodec.SAMPLES_PER_FRAME);
            System.arraycopy(decoder.decode(coder.encode(frame)), 0, result, at, SpeechCodec.SAMPLES_PER_FRAME);
        }
        rest = Arrays.copyOfRange(all, whole, all.length);
        return result;
    }
}
