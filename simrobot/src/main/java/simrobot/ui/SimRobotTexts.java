package simrobot.ui;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.ui.Texts;

/** The window's texts, English and Spanish. */
public final class SimRobotTexts {
    private SimRobotTexts() {}

    public static Texts in(Locale language) {
        Locale locale = Texts.bundleLocale(language);
        return new Texts(ResourceBundle.getBundle("simrobot.ui.messages", locale), Locale.ROOT);
    }
}
