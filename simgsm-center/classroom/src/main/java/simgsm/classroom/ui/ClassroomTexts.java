package simgsm.classroom.ui;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.console.TextBundle;

/** The texts of demo, class and lessons in the user's language. */
public final class ClassroomTexts {
    private ClassroomTexts() {}

    public static TextBundle in(Locale language) {
        Locale locale = TextBundle.bundleLocale(language);
        return new TextBundle(ResourceBundle.getBundle("simgsm.classroom.ui.messages", locale), Locale.ROOT);
    }
}
