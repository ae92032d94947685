package simgsm.tools.audio;

import java.io.IOException;

/** A readable file that is no audio of a known format. */
public final class NotAudioException extends IOException {
    NotAudioException(String text, Throwable cause) {
        super(text, cause);
    }
}
