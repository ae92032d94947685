package simgsm.center.app;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.console.TextBundle;

/** The program's texts in the user's language. */
public final class CenterTexts {
    private CenterTexts() {}

    public static TextBundle in(Locale language) {
        return new TextBundle(
                ResourceBundle.getBundle("simgsm.center.app.messages", TextBundle.bundleLocale(language)), Locale.ROOT);
    }
}
