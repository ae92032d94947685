package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Properties;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class MessagesTest {
    /** GSM 03.38 default alphabet without its control characters; the extension table counts double and is not used. */
    private static final String GSM = "@£$¥èéùìòÇØøÅåΔ_ΦΓΛΩΠΨΣΘΞÆæßÉ !\"#¤%&'()*+,-./0123456789:;<=>?¡"
            + "ABCDEFGHIJKLMNOPQRSTUVWXYZÄÖÑÜ§¿abcdefghijklmnopqrstuvwxyzäöñüà";

    private static Properties bundle(String name) throws IOException {
        Properties bundle = new Properties();
        try (InputStreamReader reader =
                new InputStreamReader(MessagesTest.class.getResourceAsStream(name), StandardCharsets.UTF_8)) {
            bundle.load(reader);
        }
        return bundle;
    }

    private static long arguments(String text) {
        return Stream.of("{0}", "{1}", "{2}", "{3}").filter(text::contains).count();
    }

    @Test
    void bothLanguagesHaveTheSameKeysWithAsManyArguments() throws IOException {
        Properties english = bundle("messages.properties");
        Properties spanish = bundle("messages_es.properties");
        assertEquals(english.keySet(), spanish.keySet());
        english.stringPropertyNames()
                .forEach(key ->
                        assertEquals(arguments(english.getProperty(key)), arguments(spanish.getProperty(key)), key));
    }

    @Test
    void whatGoesIntoAShortMessageKeepsToTheGsmAlphabet() throws IOException {
        for (String name : new String[] {"messages.properties", "messages_es.properties"}) {
            Properties bundle = bundle(name);
            bundle.stringPropertyNames().stream()
                    .filter(key -> !key.matches("(tone|verdict|course)[.].*"))
                    .forEach(key -> bundle.getProperty(key)
                            .chars()
                            .filter(character -> "{}".indexOf(character) < 0)
                            .forEach(character ->
                                    assertTrue(GSM.indexOf(character) >= 0, key + " has " + (char) character)));
        }
    }

    @Test
    void everyKeyThatTheCodeAsksForIsThere() throws IOException {
        Properties english = bundle("messages.properties");
        for (ExpectedKeys expected : ExpectedKeys.values()) {
            assertTrue(expected.keys() != null || english.containsKey("expected." + expected), expected::name);
        }
        for (OrderFault.Limit limit : OrderFault.Limit.values()) {
            assertTrue(limit == OrderFault.Limit.NONE || english.containsKey("limit." + limit), limit::name);
        }
        for (RobotStatus status : RobotStatus.values()) {
            assertEquals(status.text(), english.getProperty("status." + status));
            assertTrue(english.containsKey("reason." + status), status::name);
        }
    }

    @Test
    void theTonesMeanWhatThePaperAndTheSpecificationSay() {
        String[] english = {
            "connection accepted",
            "connection denied",
            "executed",
            "collision",
            "infinite loop",
            "executing",
            "not a valid command",
            "not possible in this status"
        };
        assertEquals(english.length, ReplyTone.values().length);
        for (ReplyTone tone : ReplyTone.values()) {
            assertEquals(english[tone.number() - 1], tone.words(Locale.ENGLISH));
            assertEquals('0' + tone.number(), tone.key());
            assertTrue(!tone.words(Locale.forLanguageTag("es")).equals(tone.words(Locale.ENGLISH)));
        }
        assertEquals("choque", ReplyTone.COLLISION.words(Locale.forLanguageTag("es")));
    }

    @Test
    void anyOtherLanguageIsEnglishInEverySystemLanguage() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag("es-MX"));
            assertEquals("executed", ReplyTone.EXECUTED.words(Locale.ENGLISH));
            assertEquals("executed", ReplyTone.EXECUTED.words(Locale.FRENCH));
        } finally {
            Locale.setDefault(before);
        }
    }
}
