package simrobot.http;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.ui.Texts;

/** The page's texts, English and Spanish. */
final class WebTexts {
    private WebTexts() {}

    static Texts in(Locale language) {
        Locale locale = Texts.bundleLocale(language);
        return new Texts(ResourceBundle.getBundle("simrobot.http.messages", locale), Locale.ROOT);
    }
}
