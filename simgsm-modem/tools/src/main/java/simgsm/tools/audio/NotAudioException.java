package simgsm.tools.audio;

import java.io.IOException;

/** A file that could be read but holds no audio that we understand. */
public final class NotAudioException extends IOException {
    NotAudioException(String text, Throwable cause) {
        super(text, cause);
    }
}
