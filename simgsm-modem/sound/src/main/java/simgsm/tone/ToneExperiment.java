package simgsm.tone;

import java.util.Optional;
import simgsm.speech.SpeechCodec;

/**
 * What a tone scope does to the sound before it listens, so that a class sees where detection ends. Only the scope hears
 * it; what is heard and sent in the call stays as it is.
 *
 * @param snrDecibels the tones' power over that of added white noise in the whole band of speech, 0 to 4 kHz, -20 to 60;
 *     infinite for none
 * @param shiftPercent how much all frequencies are raised, -10 to 10
 * @param codec through which the sound goes at last, as on its way to the far end; empty for none
 */
public record ToneExperiment(double snrDecibels, double shiftPercent, Optional<SpeechCodec.Kind> codec) {
    /** The sound as it is. */
    public static final ToneExperiment NONE = new ToneExperiment(Double.POSITIVE_INFINITY, 0);

    /** Without a codec. */
    public ToneExperiment(double snrDecibels, double shiftPercent) {
        this(snrDecibels, shiftPercent, Optional.empty());
    }

    public ToneExperiment {
        if (!(snrDecibels >= -20 && (snrDecibels <= 60 || Double.isInfinite(snrDecibels)))) {
            throw new IllegalArgumentException("SNR of " + snrDecibels + " dB (expected -20 to 60, or infinite)");
        }
        if (!(Math.abs(shiftPercent) <= 10)) {
            throw new IllegalArgumentException("Shift of " + shiftPercent + " % (expected -10 to 10)");
        }
    }

    public boolean hasNoise() {
        return !Double.isInfinite(snrDecibels);
    }
}
