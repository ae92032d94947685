package simgsm.console;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.MissingResourceException;
import java.util.ResourceBundle;

/**
 * The texts of one bundle. Each module loads its own bundle, because a named module's bundle is not visible to others, and
 * wraps it here. A missing text is replaced by its key.
 */
public final class TextBundle {
    private final ResourceBundle bundle;
    private final Locale locale;

    /** @param locale for numbers in the texts */
    public TextBundle(ResourceBundle bundle, Locale locale) {
        this.bundle = bundle;
        this.locale = locale;
    }

    /**
     * The locale for loading a bundle: Spanish for Spanish, else the root, so that English never falls back to the
     * system's language.
     */
    public static Locale bundleLocale(Locale language) {
        return language.getLanguage().equals("es") ? Locale.forLanguageTag("es") : Locale.ROOT;
    }

    /** The language of the texts; the root locale for English. */
    public Locale language() {
        return bundle.getLocale();
    }

    /** The text of a key, formatted by MessageFormat if there are arguments. */
    public String of(String key, Object... arguments) {
        String pattern;
        try {
            pattern = bundle.getString(key);
        } catch (MissingResourceException missing) {
            return key;
        }
        return arguments.length == 0 ? pattern : new MessageFormat(pattern, locale).format(arguments);
    }
}
