package vericommand;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.ResourceBundle;

/** The texts for people, English unless Spanish is asked for; a missing key is a fault of ours, not a blank. */
final class VeriCommandTexts {
    private static final ResourceBundle ENGLISH = bundle(Locale.ROOT);
    private static final ResourceBundle SPANISH = bundle(new Locale("es"));

    private VeriCommandTexts() {}

    /** @param arguments already formatted, so that numbers have a dot whatever the language */
    static String text(Locale locale, String key, String... arguments) {
        ResourceBundle bundle = "es".equals(locale.getLanguage()) ? SPANISH : ENGLISH;
        return new MessageFormat(bundle.getString(key), Locale.ROOT).format(arguments);
    }

    private static ResourceBundle bundle(Locale locale) {
        return ResourceBundle.getBundle("vericommand.messages", locale, VeriCommandTexts.class.getModule());
    }
}
