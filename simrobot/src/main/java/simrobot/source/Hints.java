package simrobot.source;

import java.util.Locale;
import java.util.ResourceBundle;

/** Hints for beginners, by the cause of a fault: the name of an exception, or a code of the compiler. */
public final class Hints {
    private final ResourceBundle texts;

    Hints(Locale language) {
        texts = ResourceBundle.getBundle("simrobot.source.hints", language);
    }

    /** Returns the text of a fault with the hint for its cause; the text alone if there is none. */
    String with(String text, String cause) {
        return texts.containsKey(cause) ? text + " (" + texts.getString(cause) + ")" : text;
    }
}
