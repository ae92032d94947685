package simgsm.modem.client;

import java.util.function.Consumer;
import simgsm.speech.CallAudioListener;

/**
 * The surroundings of an attached modem's sound.
 *
 * @param output takes frames for the modem; it must not block
 * @param recorder receives both directions of all calls
 */
public record SoundPort(Consumer<byte[]> output, CallAudioListener recorder) {
    /** The port of a modem without a line for its sound. */
    public static final SoundPort NONE = new SoundPort(frame -> {}, CallAudioListener.NONE);
}
