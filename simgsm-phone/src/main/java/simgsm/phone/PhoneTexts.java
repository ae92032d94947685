package simgsm.phone;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.ui.Texts;

/** The phone's texts, for its console and its window. */
final class PhoneTexts {
    private PhoneTexts() {}

    static Texts in(Locale language) {
        return new Texts(ResourceBundle.getBundle("simgsm.phone.messages", Texts.bundleLocale(language)), Locale.ROOT);
    }
}
