package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SystemLanguageTest {
    @ParameterizedTest
    @CsvSource({
        "es, LANG, en_GB.UTF-8, true",
        "en, LANG, es, true",
        "en, LANG, es_AR.UTF-8, true",
        "en, LC_ALL, es_ES@euro, true",
        "en, LANG, en_US.UTF-8, false",
        "en, LANG, est_EE, false",
        "en, LANGUAGE, es, false"
    })
    void isSpanishByJavaOrByTheEnvironment(String java, String name, String value, boolean spanish) {
        assertEquals(spanish, Arguments.isSpanish(Map.of(name, value), Locale.forLanguageTag(java)));
    }

    @ParameterizedTest
    @CsvSource({"C, es, false", "es_ES, en_US, true"})
    void theFirstVariableThatIsSetDecides(String all, String lang, boolean spanish) {
        assertEquals(spanish, Arguments.isSpanish(Map.of("LC_ALL", all, "LANG", lang), Locale.ENGLISH));
    }
}
