package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Keys of a call, one at a time. The result is written {@code ok:INSTRUCTIONS} or {@code POSITION:EXPECTED}. */
class CommandRecognizerTest {
    private final CommandRecognizer recognizer = new CommandRecognizer();

    private List<String> press(String keys) {
        List<String> results = new ArrayList<>();
        for (char key : OrderText.keysOf(keys).toCharArray()) {
            collect(recognizer.key(key), results);
        }
        return results;
    }

    private static void collect(Recognition recognition, List<String> results) {
        if (recognition instanceof Recognition.Complete complete) {
            results.add("ok:" + complete.order().instructionKeys().replace(" ", ""));
        } else if (recognition instanceof Recognition.Broken broken) {
            results.add(broken.fault().position() + ":" + broken.fault().expected());
        }
    }

    private List<String> silence(long samples) {
        List<String> results = new ArrayList<>();
        collect(recognizer.elapsed(samples), results);
        return results;
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "** #**20 **|#**20",
                "** #*#90 **|#*#90",
                "** ### **|###",
                "** #*0 **|#*0",
                "** #**100 #*#90 #**100 **|#**100#*#90#**100",
                "** #**1 **|#**1",
                "** #**9999 **|#**9999",
                "** #*#1 **|#*#1",
                "** #*#360 **|#*#360",
                "** #**0001 **|#**1",
                "** #*#0360 **|#*#360",
                "** #*0 ### #*0 #**5 **|#*0####*0#**5",
                "*** #**20 **|#**20",
                "**** #**20 **|#**20",
                "******* #**20 **|#**20"
            })
    void aRightOrderIsCompleteAtItsLastStar(String keys, String instructions) {
        String all = OrderText.keysOf(keys);
        assertEquals(List.of(), press(all.substring(0, all.length() - 1)));
        assertEquals(List.of("ok:" + instructions), press("*"));
        assertFalse(recognizer.isOpen());
    }

    @Test
    void anOrderKeepsTheKeysAsTheyCameButForFurtherStarsOfItsOpening() {
        press("*** #**0020 *");
        Recognition.Complete complete = (Recognition.Complete) recognizer.key('*');
        assertEquals("**#**0020**", complete.order().keys());
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "#", "12#45*6", "#*#*#*5", "A*B*", "*#**20"})
    void keysBeforeAnyOpeningAreIgnored(String keys) {
        assertEquals(List.of(), press(keys.endsWith("0") ? "*#*" : keys));
        assertFalse(recognizer.isOpen());
        assertEquals(List.of("ok:#**20"), press("7 ** #**20 **"));
    }

    @Test
    void withNothingBrokenEvenAnOpeningAfterAHashOpens() {
        assertEquals(List.of("ok:#**20"), press("#** #**20 **"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "** 2|3|HASH",
                "** A|3|HASH",
                "** x|3|HASH",
                "** #0|4|STAR_OR_HASH",
                "** #A|4|STAR_OR_HASH",
                "** #*1#|6|DIGIT_OR_CLOSING",
                "** #*12#|7|CLOSING",
                "** #*123|7|CLOSING",
                "** #*01|6|HASH_OR_STAR",
                "** #*A|5|STAR_HASH_OR_DIGIT",
                "** ##0|5|HASH",
                "** ##*|5|HASH",
                "** ###5|6|HASH_OR_STAR",
                "** #*05|6|HASH_OR_STAR",
                "** #***|6|NUMBER",
                "** #**#|6|NUMBER",
                "** #**A|6|NUMBER",
                "** #*#*|6|NUMBER",
                "** #**0*|7|NUMBER",
                "** #**0000*|10|NUMBER",
                "** #**00#|8|NUMBER",
                "** #*#361*|9|NUMBER",
                "** #*#9999#|10|NUMBER",
                "** #*#361A|9|NUMBER",
                "** #**20A|8|DIGIT_HASH_OR_STAR",
                "** #**1234A|10|HASH_OR_STAR",
                "** #**12345|10|HASH_OR_STAR",
                "** #*#00901|10|HASH_OR_STAR",
                "** #**20 *5|9|STAR",
                "** #**20 *#|9|STAR",
                "** #**20 *D|9|STAR",
                "*** 2|4|HASH",
                "***** #** #|9|NUMBER"
            })
    void aBrokenOrderIsReportedAtTheOffendingKey(String keys, int position, ExpectedKeys expected) {
        String all = OrderText.keysOf(keys);
        assertEquals(List.of(), press(all.substring(0, all.length() - 1)));
        assertEquals(List.of(position + ":" + expected), press(all.substring(all.length() - 1)));
        assertFalse(recognizer.isOpen());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "** #**|CENTIMETERS",
                "** #*#|DEGREES",
                "** #**0|CENTIMETERS",
                "** #*#361|DEGREES",
                "** #*#1234|DEGREES",
                "** #|NONE",
                "** #**5|NONE"
            })
    void theLimitIsNamedWhereARangeMatters(String keys, OrderFault.Limit limit) {
        press(keys);
        assertEquals(limit, recognizer.missing().limit());
        assertEquals(limit, ((Recognition.Broken) recognizer.key('A')).fault().limit());
    }

    @Test
    void aFifthDigitNamesTheRangeToo() {
        press("** #*#1234");
        assertEquals(
                OrderFault.Limit.DEGREES,
                ((Recognition.Broken) recognizer.key('5')).fault().limit());
    }

    @Test
    void theThirtyThirdInstructionBreaksAtItsHash() {
        press("**" + "###".repeat(32));
        OrderFault fault = ((Recognition.Broken) recognizer.key('#')).fault();
        assertEquals(2 + 96 + 1, fault.position());
        assertEquals(ExpectedKeys.CLOSING, fault.expected());
        assertEquals(OrderFault.Limit.INSTRUCTIONS, fault.limit());
    }

    @Test
    void thirtyTwoInstructionsWithNumbersAreTakenAndOneMoreIsNot() {
        assertEquals(List.of("ok:" + "#*#1".repeat(32)), press("**" + "#*#1".repeat(32) + "**"));
        assertEquals(List.of((2 + 128 + 1) + ":CLOSING"), press("**" + "#*#1".repeat(33) + "**"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "** 20 **|3:HASH",
                "** #5 #**20 **|4:STAR_OR_HASH",
                "** #**0 **|7:NUMBER",
                "** #** **|6:NUMBER",
                "** #*#361 #**5 **|9:NUMBER",
                "** #**12345 **|10:HASH_OR_STAR",
                "** #**2A **|7:DIGIT_HASH_OR_STAR",
                "** #**20 *5 **|9:STAR",
                "** #**20 *#**20 **|9:STAR",
                "** ## **|5:HASH",
                "** ##* **|5:HASH",
                "** #A** **|4:STAR_OR_HASH",
                "** 1 #** #*# ### #** 5 **|3:HASH"
            })
    void theClosingOfABrokenOrderIsSkippedAndTheNextOrderIsReadRight(String broken, String fault) {
        assertEquals(List.of(fault), press(broken));
        assertEquals(List.of("ok:#*#5"), press("** #*#5 **"));
        assertEquals(List.of(fault), press(broken));
        assertEquals(1, press(broken).size(), "the second of two broken orders in a row is reported once, too");
        assertEquals(List.of("ok:###"), press("** ### **"));
    }

    @Test
    void theOffendingKeyMayBeTheFirstStarOfTheNextOpening() {
        assertEquals(List.of("7:NUMBER"), press("** #**0*"));
        assertFalse(recognizer.isOpen());
        press("*");
        assertTrue(recognizer.isOpen());
        assertEquals("**", recognizer.keys());
        assertEquals(List.of("ok:#**7"), press("#**7 **"));
    }

    @Test
    void anOffendingStarAfterAHashIsNoFirstStar() {
        assertEquals(List.of("5:HASH"), press("** ##*"));
        press("*");
        assertFalse(recognizer.isOpen());
        press("*");
        assertTrue(recognizer.isOpen());
    }

    @Test
    void positionsOfTheNextOrderCountFromItsOwnFirstStar() {
        assertEquals(List.of("3:HASH"), press("** 9 1 2 3"));
        assertEquals(List.of("4:STAR_OR_HASH"), press("** #4"));
    }

    @Test
    void theClosingOfABrokenOrderIsTheFirstOfTheStarsThatOpenTheNext() {
        assertEquals(List.of("3:HASH"), press("** 20 **"));
        assertEquals(List.of("5:HASH"), press("** 20 **"));
    }

    @Test
    void tenSecondsWithoutAKeyDropAnOrderOnceAndNotASampleEarlier() {
        press("** #");
        assertEquals(List.of(), silence(CommandRecognizer.TIMEOUT_SAMPLES - 1));
        assertEquals(List.of("4:STAR_OR_HASH"), silence(1));
        assertEquals(List.of(), silence(CommandRecognizer.TIMEOUT_SAMPLES));
        assertFalse(recognizer.isOpen());
    }

    @Test
    void aTimeOutSaysSoAndWhatWasMissing() {
        press("** #**");
        OrderFault fault = ((Recognition.Broken) recognizer.elapsed(CommandRecognizer.TIMEOUT_SAMPLES)).fault();
        assertTrue(fault.timedOut());
        assertEquals(new OrderFault("**#**", 6, ExpectedKeys.NUMBER, OrderFault.Limit.CENTIMETERS, true), fault);
    }

    @Test
    void aTimeOutAfterFourDigitsMissesTheClosingOrAnotherInstruction() {
        press("** #**1234");
        OrderFault fault = ((Recognition.Broken) recognizer.elapsed(CommandRecognizer.TIMEOUT_SAMPLES)).fault();
        assertEquals(ExpectedKeys.HASH_OR_STAR, fault.expected());
        assertEquals(10, fault.position());
    }

    @Test
    void everyKeyStartsTheTenSecondsAgain() {
        press("** #");
        for (char key : "**20*".toCharArray()) {
            assertEquals(List.of(), silence(CommandRecognizer.TIMEOUT_SAMPLES - 1));
            press("" + key);
        }
        assertEquals(List.of("ok:#**20"), press("*"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "*", "**", "****", "12"})
    void withoutAKeyAfterTheOpeningThereIsNoTimeOut(String keys) {
        press(keys);
        assertEquals(List.of(), silence(10 * CommandRecognizer.TIMEOUT_SAMPLES));
        assertEquals(List.of("ok:#**20"), press("** #**20 **"));
    }

    /** Heard over towers, where a handover takes a key: the opening was damaged, or a closing key. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "*?*#*#4**|1:OPENING",
                "?*#*#3**|1:OPENING",
                "*#*#30**|1:OPENING",
                "###|1:OPENING",
                "**#*#*19*|",
                "** #**20 ** *#*#20**|1:OPENING"
            })
    void anOrderWhoseOpeningWasNotHeardIsAnsweredOnceAfterTenSeconds(String heard, String answer) {
        List<String> before = press(heard);
        assertEquals(List.of(), silence(CommandRecognizer.TIMEOUT_SAMPLES - 1));
        List<String> after = silence(1);

        assertEquals(answer == null ? List.of() : List.of(answer), after);
        assertEquals(answer == null ? 1 : heard.startsWith("** ") ? 1 : 0, before.size());
        assertEquals(List.of(), silence(10 * CommandRecognizer.TIMEOUT_SAMPLES));
        assertEquals(List.of("ok:#**20"), press("** #**20 **"));
        assertEquals(List.of(), silence(CommandRecognizer.TIMEOUT_SAMPLES));
    }

    @ParameterizedTest
    @ValueSource(strings = {"12", "*#", "1234567", "** #**20 **", "** 5 #*#90 **"})
    void otherKeysOutsideOrdersGetNoAnswer(String keys) {
        press(keys);
        assertEquals(List.of(), silence(10 * CommandRecognizer.TIMEOUT_SAMPLES));
    }

    @Test
    void keysBeforeAnOrderAreForgottenWithIt() {
        assertEquals(List.of("ok:#**20"), press("*#20 ** #**20 **"));
        assertEquals(List.of(), silence(CommandRecognizer.TIMEOUT_SAMPLES));
    }

    @Test
    void afterATimeOutTheNextOrderIsReadRight() {
        press("** #");
        silence(CommandRecognizer.TIMEOUT_SAMPLES);
        assertEquals(List.of("ok:#**20"), press("** #**20 **"));
        press("** #**2");
        silence(CommandRecognizer.TIMEOUT_SAMPLES);
        assertEquals(List.of(), press("0 **"), "the rest of the dropped order");
        assertEquals(List.of("ok:#**20"), press("** #**20 **"));
    }

    @Test
    void theEndOfACallForgetsAnOpenOrderAndABrokenOne() {
        press("** #**2");
        recognizer.reset();
        assertEquals(List.of(), press("0 **"));
        recognizer.reset();
        press("** 5");
        recognizer.reset();
        assertEquals(List.of("ok:#**20"), press("#** #**20 **"));
    }

    @Test
    void keysOutsideAnOrderAreNotCounted() {
        OrderFault nothingRead = new OrderFault("", 1, ExpectedKeys.OPENING, OrderFault.Limit.NONE, false);
        press("12#4");
        assertEquals(nothingRead, recognizer.missing());
        press("** ### **");
        assertEquals(nothingRead, recognizer.missing());
        press("*");
        assertEquals(2, recognizer.missing().position());
        recognizer.reset();
        assertEquals(nothingRead, recognizer.missing());
    }

    @Test
    void everyPossibleSequenceOfSixKeysLeavesARecogniserThatReadsTheNextOrder() {
        String alphabet = "*#05";
        for (int code = 0; code < Math.pow(alphabet.length(), 6); code++) {
            StringBuilder keys = new StringBuilder("**");
            for (int rest = code, i = 0; i < 6; i++, rest /= alphabet.length()) {
                keys.append(alphabet.charAt(rest % alphabet.length()));
            }
            recognizer.reset();
            press(keys.toString());
            if (!recognizer.isOpen()) {
                press("1");
                assertEquals(List.of("ok:#**20"), press("** #**20 **"), keys.toString());
            }
        }
    }
}
