package simrobot.bitmap;

import java.io.IOException;

/** A picture or its description cannot be read; the message says what was found and what was expected. */
final class PictureFormatException extends IOException {
    PictureFormatException(String source, String text) {
        super(source + ": " + text);
    }
}
