package simgsm.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.Optional;
import java.util.PropertyResourceBundle;
import java.util.ResourceBundle;
import org.junit.jupiter.api.Test;
import simgsm.speech.SpeechCodec;
import simgsm.ui.scope.CodecText;

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
    void theCodecIsNamedOnceWhereBothEndsAgreeAndTwiceWhereNot() {
        Optional<SpeechCodec.Kind> full = Optional.of(SpeechCodec.Kind.GSM_FULL_RATE);
        assertEquals("A-law", CodecText.of(Optional.of(SpeechCodec.Kind.A_LAW), Optional.empty(), Locale.ENGLISH));
        assertEquals("GSM 06.10", CodecText.of(Optional.of(SpeechCodec.Kind.GSM_FULL_RATE), full, Locale.ENGLISH));
        assertEquals(
                "A-law out, GSM 06.10 in", CodecText.of(Optional.of(SpeechCodec.Kind.A_LAW), full, Locale.ENGLISH));
    }

    @Test
    void everyLinkStateHasAWord() {
        for (LinkState state : LinkState.values()) {
            assertNotEquals("link." + state.name().toLowerCase(Locale.ROOT), state.word(Locale.ENGLISH));
        }
    }
}
