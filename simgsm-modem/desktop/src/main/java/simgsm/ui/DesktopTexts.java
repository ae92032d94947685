package simgsm.ui;

import java.util.Locale;
import java.util.ResourceBundle;

/** The texts of the shared pieces. */
final class DesktopTexts {
    private DesktopTexts() {}

    static Texts in(Locale language) {
        Locale locale = Texts.bundleLocale(language);
        return new Texts(ResourceBundle.getBundle("simgsm.ui.messages", locale), Locale.ROOT);
    }
}
