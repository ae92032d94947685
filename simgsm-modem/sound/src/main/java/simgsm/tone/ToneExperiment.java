package simgsm.tone;

import java.util.Optional;
import simgsm.speech.SpeechCodec;

/**
 * A disturbance of a tone scope's sound, which shows the limits of detection. The call itself is not changed.
 *
 * @param snrDecibels the tones' power over that of added white noise in the whole band of speech, 0 to 4 kHz, -20 to
 *     60; infinite for none
 * @param shiftPercent rise of all frequencies, -10 to 10
 * @param codec applied last, as between the ends of a call; empty for none
 */
public record ToneExperiment(double snrDecibels, double shiftPercent, Optional<SpeechCodec.Kind> codec) {
    /** The undisturbed sound. */
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
