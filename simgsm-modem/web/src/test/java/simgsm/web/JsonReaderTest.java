package simgsm.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.math.BigDecimal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class JsonReaderTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\0',
            value = {
                "{}|{}",
                " { \"a\" : [ 1 , -2.5e3 , null ] , \"b\":{\"c\":true}}|{a=[1, -2.5E+3, null], b={c=true}}",
                "[]|[]",
                "false|false",
                "{\"a\":1,\"a\":2}|{a=2}",
            })
    void valuesAreRead(String json, String value) {
        assertEquals(value.strip(), String.valueOf(JsonReader.parse(json)).strip());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '\0',
            value = {
                "{\"a\":}|6",
                "[1,]|4",
                "{\"a\" 1}|6",
                "01|2",
                "tru|1",
                "\"a|3",
                "\"\\x\"|4",
                "{a:1}|2",
                "[1 2]|4",
                "1 1|3",
                "1e999999|8",
            })
    void whatIsNotJsonIsRefusedAtItsPosition(String json, int position) {
        String text = assertThrows(IllegalArgumentException.class, () -> JsonReader.parse(json))
                .getMessage();
        assertEquals("JSON, position " + position, text.substring(0, text.indexOf(':')), text);
    }

    @Test
    void escapesAreRead() {
        assertEquals("q\"\\/\u00e9\n", JsonReader.parse("\"q\\\"\\\\\\/\\u00e9\\n\""));
    }

    @Test
    void depthIsLimited() {
        assertThrows(IllegalArgumentException.class, () -> JsonReader.parse("[".repeat(100_000)));
    }

    @Test
    void anObjectIsExpected() {
        assertEquals(new BigDecimal(7), JsonReader.object("{\"id\":7}").get("id"));
        assertThrows(IllegalArgumentException.class, () -> JsonReader.object("[]"));
    }
}
