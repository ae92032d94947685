package simgsm.phone;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.console.TextBundle;

/** The phone's texts, for its console and its window. */
final class PhoneTexts {
    private PhoneTexts() {}

    static TextBundle in(Locale language) {
        return new TextBundle(
                ResourceBundle.getBundle("simgsm.phone.messages", TextBundle.bundleLocale(language)), Locale.ROOT);
    }
}
