package simgsm.gateway;

import java.util.Locale;
import java.util.ResourceBundle;
import simgsm.console.TextBundle;
import simgsm.web.JsonText;

/** The words of the phone, which the page shares, and those of the page. */
final class PageWords {
    private static final char FIRST_TONE = '1';
    private static final char LAST_TONE = '8';

    private final ResourceBundle phone;
    private final ResourceBundle page;

    PageWords(Locale language) {
        Locale locale = TextBundle.bundleLocale(language);
        phone = ResourceBundle.getBundle("simgsm.gateway.phone-words.messages", locale);
        page = messages(locale);
    }

    /** The gateway's own words, without the phone's. */
    static TextBundle own(Locale language) {
        Locale locale = TextBundle.bundleLocale(language);
        return new TextBundle(messages(locale), locale);
    }

    private static ResourceBundle messages(Locale locale) {
        return ResourceBundle.getBundle("simgsm.gateway.messages", locale);
    }

    /** The meaning of a robot's reply tone; empty for other keys. */
    String toneMeaning(char key) {
        return key >= FIRST_TONE && key <= LAST_TONE ? phone.getString("tone." + key) : "";
    }

    /** All words for the page's script, as one JSON object. */
    String json() {
        JsonText json = new JsonText().open('{');
        phone.keySet().stream()
                .filter(key -> key.startsWith("tone.") || key.startsWith("cause."))
                .sorted()
                .forEach(key -> json.name(key).value(phone.getString(key)));
        page.keySet().stream().sorted().forEach(key -> json.name(key).value(page.getString(key)));
        return json.close('}').toString();
    }
}
