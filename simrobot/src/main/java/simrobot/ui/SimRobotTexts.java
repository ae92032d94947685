package simrobot.ui;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.console.TextBundle;

/** The window's texts, English and Spanish. */
public final class SimRobotTexts {
    private SimRobotTexts() {}

    public static TextBundle in(Locale language) {
        Locale locale = TextBundle.bundleLocale(language);
        return new TextBundle(ResourceBundle.getBundle("simrobot.ui.messages", locale), Locale.ROOT);
    }
}
