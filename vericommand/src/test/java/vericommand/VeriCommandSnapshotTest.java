package vericommand;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** What a window is given to show. */
class VeriCommandSnapshotTest {
    private final Bench bench = Bench.in(RobotStatus.STOPPED).call();

    private VeriCommandSnapshot shown() {
        return bench.veri.snapshot();
    }

    @Test
    void keysAreShownAsTheyCome() {
        bench.press("**#*");
        assertEquals("**#*", shown().keys());
        assertEquals("", shown().verdictWord());
        assertEquals(Bench.CALLER, shown().from());
        assertTrue(shown().inCall());
        assertFalse(shown().message());
    }

    @Test
    void aCompleteOrderIsShownInWordsWithItsVerdictAndReplies() {
        bench.press("** #**20 **");
        assertEquals("**#**20**", shown().keys());
        assertEquals("forward 20 cm", shown().words());
        assertEquals("accepted", shown().verdictWord());
        assertTrue(shown().underWay());
        bench.robot.collide(3);
        assertEquals(List.of("4 Collision after 3 of 20 cm, instruction 1 of 1."), shown().replies());
        assertFalse(shown().underWay());
    }

    @Test
    void aBrokenOrderShowsItsFailingPositionUntilTheNextBegins() {
        bench.press("** #**0 **");
        VeriCommandSnapshot broken = shown();
        assertEquals("invalid", broken.verdictWord());
        assertEquals(7, broken.failingPosition());
        assertEquals("Not a valid command: number expected at key 7. Range 1..9999 cm.", broken.verdictText());
        assertEquals('*', "**#**0**".charAt(broken.failingPosition() - 1));
        bench.press("#");
        assertEquals(0, shown().failingPosition());
        assertEquals("**#", shown().keys());
    }

    @Test
    void aMessageTakesTheLineAndTheCallTakesItBackWithItsNextKey() {
        bench.press("** #*");
        bench.sms("** #*#90 **");
        assertTrue(shown().message());
        assertEquals("5550101", shown().from());
        assertEquals("turn right 90 degrees", shown().words());
        bench.press("*");
        assertFalse(shown().message());
        assertEquals("**#**", shown().keys());
        assertEquals(Bench.CALLER, shown().from());
    }

    @Test
    void manyKeysAndRepliesStayBounded() {
        for (int i = 0; i < 500; i++) {
            bench.press("** 9 1 2 3 4 5 6 7 8");
        }
        bench.press("7".repeat(1000));
        assertTrue(shown().keys().length() <= 320, shown().keys());
        assertEquals(8, shown().replies().size());
    }
}
