package simgsm.modem.client;

import java.util.Optional;
import java.util.function.Consumer;
import simgsm.modem.VoiceStore;
import simgsm.speech.CallAudioListener;
import simgsm.words.Prompts;

/**
 * The surroundings of an attached modem's sound.
 *
 * @param output takes frames for the modem; it must not block
 * @param recorder receives both directions of all calls
 * @param prompts as in {@link simgsm.modem.ModemOptions}
 * @param voices as in {@link simgsm.modem.ModemOptions}
 */
public record SoundPort(
        Consumer<byte[]> output, CallAudioListener recorder, Optional<Prompts> prompts, Optional<VoiceStore> voices) {
    /** The port of a modem without a line for its sound. */
    public static final SoundPort NONE = new SoundPort(frame -> {}, CallAudioListener.NONE);

    /** Keys and tones only. */
    public SoundPort(Consumer<byte[]> output, CallAudioListener recorder) {
        this(output, recorder, Optional.empty(), Optional.empty());
    }
}
