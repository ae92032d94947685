package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The edges of the command language in a call, walked through sound with a clock moved by hand. */
class OrderEdgesTest {
    private final VirtualSuite suite = new VirtualSuite();
    private final VirtualPhone phone = suite.inCall();

    /** Tones behind the first, with the position that a 7 names. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                // the opening
                "*** #*0 **|3|",
                "**** #*0 **|3|",
                "12#9 ** #*0 **|3|",
                "#*0 **||",
                "** **||",
                "* #*0 **||",
                // numbers, and the key at which they are found wrong
                "** #**1 **|63|",
                "** #**0001 **|63|",
                "** #**9999 **|6|",
                "** #*#1 **|63|",
                "** #*#360 **|63|",
                "** #** **|7|key 6",
                "** #**0 **|7|key 7",
                "** #**0000 **|7|key 10",
                "** #**12345|7|key 10",
                "** #**00001|7|key 10",
                "** #*#361 **|7|key 9",
                "** #*#0 **|7|key 7",
                // what fits nowhere
                "** 5|7|key 3",
                "** ##*|7|key 5",
                "** #*A|7|key 5",
                "** #*5 **|7|key 5",
                "** ### 5|7|key 6",
                "** #*0 5|7|key 6",
                "** #**20 *5|7|key 9",
                // a broken order leaves no trace, and gets exactly one reply
                "** 5 #*0 ** #*0 **|73|key 3",
                "** #**12345 ** ** #*0 **|73|key 10",
                "** #** ** #*0 **|73|key 6",
                "** 5678 99 ##|7|key 3",
                // skipping: a ** whose first * follows a # opens nothing
                "** 5 #**20 ** #*0 **|73|key 3",
                "** 5 #** 7 #** 8|7|key 3",
                "** 5 #*** #*0 **|73|key 3",
                // two orders in a row
                "** #*0 ** ** #*0 **|33|"
            })
    void anEdgeIsAnsweredAsTheLanguageSays(String keys, String tones, String position) {
        phone.press(keys);
        suite.seconds(6);
        assertEquals("1" + (tones == null ? "" : tones), phone.tones());
        List<String> sevens = suite.robotLines("outcome robot=robot tone=7");
        assertEquals(position == null ? 0 : 1, sevens.size());
        assertTrue(position == null || sevens.get(0).contains("at " + position + "."), sevens.toString());
    }

    @ParameterizedTest
    @ValueSource(chars = {'A', 'B', 'C', 'D'})
    void aLetterNeverOccursInAnOrder(char letter) {
        phone.press("** " + letter);
        suite.seconds(1);
        phone.press("** #**20" + letter);
        suite.seconds(1);
        assertEquals("177", phone.tones());
        assertEquals(0, suite.robot.xMeters());
    }

    @Test
    void thirtyTwoInstructionsAreTakenAndTheThirtyThirdIsTheFault() {
        phone.press("**" + "#*0".repeat(32) + "**");
        suite.seconds(1);
        assertEquals("13", phone.tones());
        phone.press("**" + "#*0".repeat(33));
        suite.seconds(1);
        assertEquals("137", phone.tones());
    }

    @Test
    void tenSecondsWithoutAKeyDropAnOrderWithSeven() {
        phone.press("** #**2");
        suite.seconds(9.7);
        assertEquals("1", phone.tones());
        suite.seconds(0.6);
        assertEquals("17", phone.tones());
        phone.press("0 **");
        suite.seconds(5);
        assertEquals("17", phone.tones(), "what comes behind belongs to no order");
        assertEquals(0, suite.robot.xMeters());
    }

    @Test
    void aKeyBeforeTheTenSecondsAreOverStartsThemAgain() {
        phone.press("** #**2");
        suite.seconds(9);
        phone.press("0");
        suite.seconds(9);
        phone.press("**");
        suite.seconds(4);
        assertEquals("163", phone.tones());
    }

    @Test
    void anEmptyOrderIsNotAnsweredAtItsTimeOutNorAtHangUpNorInTheNextCall() {
        phone.press("**");
        suite.seconds(25);
        phone.hangUp();
        suite.seconds(1);
        phone.dial(VirtualSuite.ROBOT);
        suite.seconds(12);
        assertEquals("11", phone.tones());
        assertEquals(List.of(), suite.robotLines("outcome"));
    }

    @Test
    void theEndOfACallForgetsAnUnfinishedOrder() {
        phone.press("** #**20");
        phone.hangUp();
        suite.seconds(1);
        phone.dial(VirtualSuite.ROBOT);
        suite.seconds(1);
        phone.press("**");
        suite.seconds(4);
        assertEquals("11", phone.tones());
        assertEquals(0, suite.robot.xMeters());
    }
}
