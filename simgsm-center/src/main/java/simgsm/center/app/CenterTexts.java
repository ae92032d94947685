package simgsm.center.app;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.ui.Texts;

/** The program's texts in the user's language. */
public final class CenterTexts {
    private CenterTexts() {}

    public static Texts in(Locale language) {
        return new Texts(
                ResourceBundle.getBundle("simgsm.center.app.messages", Texts.bundleLocale(language)), Locale.ROOT);
    }
}
