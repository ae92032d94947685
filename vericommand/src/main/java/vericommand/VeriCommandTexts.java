package vericommand;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;

/** The user texts: Spanish, or English for every other language. */
final class VeriCommandTexts {
    private static final ResourceBundle ENGLISH = bundle(Locale.ROOT);
    private static final ResourceBundle SPANISH = bundle(new Locale("es"));

    private VeriCommandTexts() {}

    /**
     * @param arguments already formatted, numbers with a dot in every language
     * @throws java.util.MissingResourceException if the key has no text
     */
    static String text(Locale locale, String key, String... arguments) {
        ResourceBundle bundle = "es".equals(locale.getLanguage()) ? SPANISH : ENGLISH;
        return new MessageFormat(bundle.getString(key), Locale.ROOT).format(arguments);
    }

    private static ResourceBundle bundle(Locale locale) {
        return ResourceBundle.getBundle("vericommand.messages", locale, VeriCommandTexts.class.getModule());
    }
}
