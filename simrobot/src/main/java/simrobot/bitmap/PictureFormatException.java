package simrobot.bitmap;

import java.io.IOException;

/** A picture or its description cannot be read; the message names the value found and the expected one. */
final class PictureFormatException extends IOException {
    PictureFormatException(String source, String text) {
        super(source + ": " + text);
    }
}
