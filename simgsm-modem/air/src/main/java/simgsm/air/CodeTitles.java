package simgsm.air;

import java.util.Locale;
import java.util.ResourceBundle;

/** Titles of causes in Spanish, by the names of the constants. */
final class CodeTitles {
    private static final Locale LANGUAGE = Locale.forLanguageTag("es");
    private static final ResourceBundle SPANISH = ResourceBundle.getBundle("simgsm.air.titles", LANGUAGE);

    private CodeTitles() {}

    static String of(Coded.Titled value, Locale language) {
        boolean isTranslated = language.getLanguage().equals("es") && SPANISH.containsKey(value.name());
        return isTranslated ? SPANISH.getString(value.name()) : value.title();
    }
}
