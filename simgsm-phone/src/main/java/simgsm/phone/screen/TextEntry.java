package simgsm.phone.screen;

import java.util.concurrent.TimeUnit;
import simgsm.dtmf.DtmfKey;

/**
 * Writing with twelve keys: each press of the same key within a second selects its next letter. The keys have only
 * letters of the GSM alphabet, which keeps messages short; a keyboard can write any.
 */
public final class TextEntry {
    /** Time in which the same key changes the last letter. */
    public static final long TAP_NANOS = TimeUnit.MILLISECONDS.toNanos(1000);
    /** The longest message: 255 parts of 153 letters. */
    static final int MAX_CHARACTERS = 39_015;

    /** The case of the letters, or digits. */
    public enum Mode {
        LOWER,
        /** The next letter is a capital, then as LOWER. */
        CAPITAL,
        UPPER,
        NUMBERS;

        Mode next() {
            return values()[(ordinal() + 1) % values().length];
        }
    }

    private static final String[] LETTERS = {
        " 0\n",
        ".,?!'-:@1",
        "abc2\u00e0\u00e5\u00e4\u00e6",
        "def3\u00e9\u00e8",
        "ghi4\u00ec",
        "jkl5",
        "mno6\u00f1\u00f2\u00f6\u00f8",
        "pqrs7\u00df",
        "tuv8\u00fc\u00f9",
        "wxyz9"
    };
    private static final String STAR_LETTERS = "*+/=%&()<>";
    private static final String HASH_LETTERS = "#_$\"\u00bf\u00a1;";

    private final LineEditor line;
    private Mode mode = Mode.CAPITAL;
    private DtmfKey tapped;
    private int taps;
    private long tappedNanos;

    /** For messages. */
    TextEntry() {
        this(MAX_CHARACTERS);
    }

    TextEntry(int most) {
        line = new LineEditor(most);
    }

    /** One of the twelve keys was pressed. */
    void tap(DtmfKey key, long nowNanos) {
        settle(nowNanos);
        if (mode == Mode.NUMBERS) {
            line.insert(key.symbol());
            return;
        }
        String letters = lettersOf(key);
        boolean isNext = key == tapped;
        taps = isNext ? taps + 1 : 0;
        if (isNext) {
            line.erase();
        }
        tapped = line.insert(cased(letters.charAt(taps % letters.length()))) ? key : null;
        tappedNanos = nowNanos;
    }

    /** A character from a keyboard. */
    void type(char character) {
        commit();
        line.insert(character);
    }

    /** Erases the character before the cursor. */
    void erase() {
        commit();
        line.erase();
    }

    /** Moves the cursor. */
    void left() {
        commit();
        line.left();
    }

    /** Makes the pending letter final; without one, moves the cursor. */
    void right() {
        if (isPending()) {
            commit();
        } else {
            line.right();
        }
    }

    void set(String text) {
        commit();
        line.set(text);
    }

    void nextMode() {
        commit();
        mode = mode.next();
    }

    void setMode(Mode newMode) {
        commit();
        mode = newMode;
    }

    /** Makes the pending letter final. */
    void commit() {
        if (tapped != null
                && mode == Mode.CAPITAL
                && Character.isLetter(line.text().charAt(line.caret() - 1))) {
            mode = Mode.LOWER;
        }
        tapped = null;
        taps = 0;
    }

    /** Makes the pending letter final after one second. @return true if it did */
    boolean settle(long nowNanos) {
        if (tapped != null && nowNanos - tappedNanos >= TAP_NANOS) {
            commit();
            return true;
        }
        return false;
    }

    void clear() {
        line.set("");
        tapped = null;
        taps = 0;
        mode = Mode.CAPITAL;
    }

    private char cased(char letter) {
        // The capital of sharp s is two letters, and some capitals are not in the GSM alphabet.
        boolean upper = mode == Mode.UPPER || mode == Mode.CAPITAL;
        return upper && (letter < 0x80 || "\u00e5\u00e4\u00e6\u00e9\u00f1\u00f6\u00f8\u00fc".indexOf(letter) >= 0)
                ? Character.toUpperCase(letter)
                : letter;
    }

    private static String lettersOf(DtmfKey key) {
        return switch (key.symbol()) {
            case '*' -> STAR_LETTERS;
            case '#' -> HASH_LETTERS;
            default -> LETTERS[key.symbol() - '0'];
        };
    }

    String text() {
        return line.text();
    }

    /** The number of characters before the cursor. */
    int caret() {
        return line.caret();
    }

    Mode mode() {
        return mode;
    }

    /** True if the last letter may still change. */
    boolean isPending() {
        return tapped != null;
    }

    /** The letters of the pending one's key; empty if none is pending. */
    String choices() {
        return tapped == null ? "" : lettersOf(tapped);
    }
}
