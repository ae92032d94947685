package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.PropertyResourceBundle;
import java.util.ResourceBundle;
import org.junit.jupiter.api.Test;

/** The shared pieces' texts say the same things in both languages. */
class UiBundleTest {
    private final ResourceBundle english = ResourceBundle.getBundle("simgsm.ui.messages", Locale.ROOT);
    private final PropertyResourceBundle spanish =
            (PropertyResourceBundle) ResourceBundle.getBundle("simgsm.ui.messages", Locale.forLanguageTag("es"));

    @Test
    void everyTextIsTranslatedWithTheSameParameters() {
        for (String key : english.keySet()) {
            Object own = spanish.handleGetObject(key);
            assertNotEquals(null, own, key);
            assertEquals(parameters(english.getString(key)), parameters(own.toString()), key);
        }
    }

    private static int parameters(String pattern) {
        return new MessageFormat(pattern, Locale.ROOT).getFormatsByArgumentIndex().length;
    }

    @Test
    void everyLinkStateHasAWord() {
        for (LinkState state : LinkState.values()) {
            assertNotEquals("link." + state.name().toLowerCase(Locale.ROOT), state.word(Locale.ENGLISH));
        }
    }
}
