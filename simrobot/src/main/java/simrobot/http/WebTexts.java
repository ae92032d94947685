package simrobot.http;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.console.TextBundle;

/** The page's texts, English and Spanish. */
final class WebTexts {
    private WebTexts() {}

    static TextBundle in(Locale language) {
        Locale locale = TextBundle.bundleLocale(language);
        return new TextBundle(ResourceBundle.getBundle("simrobot.http.messages", locale), Locale.ROOT);
    }
}
