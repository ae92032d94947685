package simgsm.center;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.ui.Texts;

/** The program's texts in the user's language. */
final class Messages {
    private Messages() {}

    static Texts in(Locale language) {
        return new Texts(ResourceBundle.getBundle("simgsm.center.messages", Texts.bundleLocale(language)), Locale.ROOT);
    }
}
