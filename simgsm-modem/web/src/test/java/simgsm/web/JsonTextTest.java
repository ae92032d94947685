package simgsm.web;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class JsonTextTest {
    @Test
    void objectsAndArraysAreSeparatedByCommas() {
        JsonText json = new JsonText()
                .open('{')
                .name("empty")
                .open('[')
                .close(']')
                .name("robots")
                .open('[')
                .open('{')
                .name("id")
                .value(1)
                .close('}')
                .open('{')
                .name("id")
                .value(2)
                .name("moves")
                .value(true)
                .close('}')
                .close(']')
                .name("ok")
                .value(false)
                .close('}');
        assertEquals("{\"empty\":[],\"robots\":[{\"id\":1},{\"id\":2,\"moves\":true}],\"ok\":false}", json.toString());
    }

    @Test
    void anyValueIsWrittenAsItWasReadAndWhatIsNotFiniteAsNull() {
        String text = "{\"a\":[1,2.50,\"x\",true,null,{}],\"b\":-1E+3}";
        assertEquals(text, new JsonText().any(JsonReader.parse(text)).toString());
        List<Object> numbers = List.of(0.5, Double.NaN, Float.NEGATIVE_INFINITY, 7);
        assertEquals("[0.5,null,null,7]", new JsonText().any(numbers).toString());
    }

    @Test
    void quotesBackslashesAndControlsAreEscapedAndNothingElse() {
        String text = "a\"b\\c\n\t\u0000\u001f /\u007f\u00f1\ud83e\udd16";
        assertEquals(
                "\"a\\\"b\\\\c\\n\\t\\u0000\\u001f /\\u007f\u00f1\ud83e\udd16\"",
                new JsonText().value(text).toString());
    }

    @Test
    void namesAreEscapedLikeValues() {
        assertEquals(
                "{\"a\\\"b\":\"\"}",
                new JsonText().open('{').name("a\"b").value("").close('}').toString());
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0, 0",
        "1.005, 1, 1.0",
        "-1.25, 3, -1.250",
        "-0.0004, 3, 0.000",
        "-0.0, 1, 0.0",
        "-0.4, 0, 0",
        "-0.0006, 3, -0.001",
        "1e12, 1, 1000000000000.0",
        "1e-9, 2, 0.00"
    })
    void numbersHaveTheirDecimalsNoExponentAndNoMinusZero(double value, int decimals, String expected) {
        assertEquals(expected, new JsonText().value(value, decimals).toString());
    }

    @Test
    void theLargestWholeNumbersAreWhole() {
        assertEquals(
                "[9223372036854775807,-9223372036854775808]",
                new JsonText()
                        .open('[')
                        .value(Long.MAX_VALUE)
                        .value(Long.MIN_VALUE)
                        .close(']')
                        .toString());
    }

    @Test
    void theDecimalPointIsAPointInEveryCountry() {
        Locale before = Locale.getDefault();
        Locale.setDefault(new Locale("es", "ES"));
        try {
            assertEquals("1234.5", new JsonText().value(1234.5, 1).toString());
        } finally {
            Locale.setDefault(before);
        }
    }
}
