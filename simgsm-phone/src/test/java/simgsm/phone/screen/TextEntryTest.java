package simgsm.phone.screen;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import simgsm.dtmf.DtmfKey;
import simgsm.phone.screen.TextEntry.Mode;
import simgsm.sms.Alphabet;

/** Multi-tap writing. */
class TextEntryTest {
    private final TextEntry entry = new TextEntry();
    private long nowNanos;

    private void tap(String keys) {
        for (char key : keys.toCharArray()) {
            entry.tap(DtmfKey.of(key), nowNanos);
        }
    }

    private void pause() {
        nowNanos += TextEntry.TAP_NANOS;
    }

    @Test
    void theSameKeyWithinASecondTakesTheNextLetter() {
        entry.setMode(Mode.LOWER);
        tap("777");
        assertEquals("r", entry.text());
    }

    @Test
    void theSameKeyAfterASecondWritesAnotherLetter() {
        entry.setMode(Mode.LOWER);
        tap("2");
        pause();
        tap("2");
        assertEquals("aa", entry.text());
    }

    @Test
    void oneNanosecondBeforeTheSecondIsOverItIsStillTheSameLetter() {
        entry.setMode(Mode.LOWER);
        tap("2");
        nowNanos += TextEntry.TAP_NANOS - 1;
        tap("2");
        assertEquals("b", entry.text());
    }

    @Test
    void anotherKeyNeedsNoPause() {
        entry.setMode(Mode.LOWER);
        tap("4433555");
        assertEquals("hel", entry.text());
    }

    @Test
    void theLettersOfAKeyComeRound() {
        entry.setMode(Mode.LOWER);
        tap("5555" + "5");
        assertEquals("j", entry.text());
    }

    @Test
    void theFirstLetterIsACapitalAndTheNextIsNot() {
        tap("2");
        pause();
        tap("22");
        assertEquals("Ab", entry.text());
    }

    @Test
    void theNumberModeWritesOrdersAsTheyAre() {
        entry.setMode(Mode.NUMBERS);
        tap("**#**20**");
        assertEquals("**#**20**", entry.text());
        assertFalse(entry.isPending());
    }

    @Test
    void ordersCanBeTappedInEveryMode() {
        entry.setMode(Mode.LOWER);
        tap("*");
        pause();
        tap("*");
        tap("#");
        assertEquals("**#", entry.text());
    }

    @Test
    void theModesComeRound() {
        Mode first = entry.mode();
        for (int i = 0; i < Mode.values().length; i++) {
            entry.nextMode();
        }
        assertEquals(first, entry.mode());
    }

    @Test
    void erasingTakesOneLetterAndAPairOfSurrogatesAsOne() {
        entry.type('a');
        "\ud83e\udd16".chars().forEach(half -> entry.type((char) half));
        entry.erase();
        assertEquals("a", entry.text());
        entry.erase();
        entry.erase();
        assertEquals("", entry.text());
    }

    @Test
    void aLetterStandsOnceItsSecondIsOver() {
        tap("2");
        assertTrue(entry.isPending());
        assertFalse(entry.settle(nowNanos + TextEntry.TAP_NANOS - 1));
        assertTrue(entry.settle(nowNanos + TextEntry.TAP_NANOS));
        assertFalse(entry.isPending());
    }

    @Test
    void everyLetterOnTheKeysIsOfTheGsmAlphabetInEveryMode() {
        for (Mode mode : Mode.values()) {
            for (char key : "0123456789*#".toCharArray()) {
                for (int taps = 1; taps <= 12; taps++) {
                    entry.clear();
                    entry.setMode(mode);
                    tap(String.valueOf(key).repeat(taps));
                    assertEquals(Alphabet.GSM_7BIT, Alphabet.of(entry.text()), mode + " " + key + " " + entry.text());
                }
            }
        }
    }

    @Test
    void aTextThatIsAsLongAsAnyMessageTakesNoMore() {
        for (int i = 0; i < TextEntry.MAX_CHARACTERS + 5; i++) {
            entry.type('x');
        }
        tap("2");
        assertEquals(TextEntry.MAX_CHARACTERS, entry.text().length());
    }
}
