package simgsm.ui;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.console.TextBundle;

/** The texts of this module's components. */
public final class DesktopTexts {
    private DesktopTexts() {}

    public static TextBundle in(Locale language) {
        Locale locale = TextBundle.bundleLocale(language);
        return new TextBundle(ResourceBundle.getBundle("simgsm.ui.messages", locale), Locale.ROOT);
    }
}
