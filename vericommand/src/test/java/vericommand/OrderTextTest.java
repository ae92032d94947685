package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The order of a short message. */
class OrderTextTest {
    private static final ReplyTexts TEXTS = new ReplyTexts(Locale.ENGLISH);

    private static String replyTo(String text) {
        return TEXTS.invalid(((Recognition.Broken) OrderText.read(text)).fault())
                .message();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "**#**20**",
                "** #**20 **",
                "* * # * * 2 0 * *",
                "** #**20\n**",
                " \r\n**\t#**0020** ",
                "*** #**20 **",
                "**\u00a0#**20 **"
            })
    void blanksAndLineBreaksBetweenKeysAreIgnored(String text) {
        Recognition.Complete complete = (Recognition.Complete) OrderText.read(text);
        assertEquals("** #**20 **", complete.order().text());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "``|** expected at key 1.",
                "hello|** expected at key 1.",
                "1** #**20 **|** expected at key 1.",
                "#** #**20 **|** expected at key 1.",
                "*|* expected at key 2.",
                "*5|* expected at key 2.",
                "**|# expected at key 3.",
                "** **|# expected at key 5.",
                "** 20 **|# expected at key 3.",
                "** #a*20 **|* or # expected at key 4.",
                "** #*5 #**1 **|digit or ** expected at key 6.",
                "** #*12 #**1 **|** expected at key 7.",
                "** ##* **|# expected at key 5.",
                "** #** **|number expected at key 6. Range 1..9999 cm.",
                "** #*# **|number expected at key 6. Range 1..360 degrees.",
                "** #**0 **|number expected at key 7. Range 1..9999 cm.",
                "** #**0000 **|number expected at key 10. Range 1..9999 cm.",
                "** #*#361 **|number expected at key 9. Range 1..360 degrees.",
                "** #**12345 **|# or * expected at key 10. Range 1..9999 cm.",
                "** #**2A **|digit or # or * expected at key 7.",
                "** #**2 0 a **|digit or # or * expected at key 8.",
                "** #**20|digit or # or * expected at key 8.",
                "** #*#361|number expected at key 9. Range 1..360 degrees.",
                "** #**|number expected at key 6. Range 1..9999 cm.",
                "** #**20 *|* expected at key 9.",
                "** ### *x|* expected at key 7.",
                "** #**20 ** x|end expected at key 10.",
                "** #**20 ** *|end expected at key 10.",
                "** #**20 ** ** #**20 **|end expected at key 10."
            })
    void aFaultIsReportedWithItsPositionAndWhatWasExpected(String text, String fault) {
        assertEquals("7 Not a valid command: " + fault, replyTo(text));
    }

    @Test
    void onlyTheFirstFaultIsReported() {
        assertEquals("7 Not a valid command: # expected at key 3.", replyTo("** 5 #** A ** 7 **"));
    }

    @Test
    void moreThanThirtyTwoInstructionsAreRefusedAtTheNextHash() {
        assertEquals(
                "7 Not a valid command: ** expected at key 131. At most 32 instructions.",
                replyTo("**" + "#*#1".repeat(33) + "**"));
    }

    @Test
    void aFaultHoldsTheKeysOfTheWholeText() {
        assertEquals(
                "**5#**20**",
                ((Recognition.Broken) OrderText.read("** 5 #**20 **")).fault().keys());
    }

    @Test
    void charactersBeyondTheBasicPlaneAreOneFaultLikeAnyOther() {
        assertEquals("7 Not a valid command: # expected at key 3.", replyTo("** \ud83d\ude00 **"));
    }
}
