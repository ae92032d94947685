package simgsm.dtmf;

import java.util.ArrayList;
import java.util.List;

/** The sixteen keys with their two tones each (ITU-T Q.23). */
public enum DtmfKey {
    ONE('1'),
    TWO('2'),
    THREE('3'),
    A('A'),
    FOUR('4'),
    FIVE('5'),
    SIX('6'),
    B('B'),
    SEVEN('7'),
    EIGHT('8'),
    NINE('9'),
    C('C'),
    STAR('*'),
    ZERO('0'),
    HASH('#'),
    D('D');

    /** Low group, top row first. */
    static final double[] ROW_HERTZ = {697, 770, 852, 941};
    /** High group, left column first. */
    static final double[] COLUMN_HERTZ = {1209, 1336, 1477, 1633};

    private static final DtmfKey[] KEYS = values();

    private final char symbol;

    DtmfKey(char symbol) {
        this.symbol = symbol;
    }

    /** One of {@code 0123456789*#ABCD}. */
    public char symbol() {
        return symbol;
    }

    /** 0 to 3, from the top. */
    public int row() {
        return ordinal() / 4;
    }

    /** 0 to 3, from the left. */
    public int column() {
        return ordinal() % 4;
    }

    public double rowHertz() {
        return ROW_HERTZ[row()];
    }

    public double columnHertz() {
        return COLUMN_HERTZ[column()];
    }

    public static DtmfKey at(int row, int column) {
        if (row < 0 || row > 3 || column < 0 || column > 3) {
            throw new IllegalArgumentException("No key in row " + row + ", column " + column);
        }
        return KEYS[4 * row + column];
    }

    public static boolean isKey(char symbol) {
        return "0123456789*#ABCD".indexOf(symbol) >= 0;
    }

    /** IllegalArgumentException for anything but {@code 0123456789*#ABCD}, including lower-case letters. */
    public static DtmfKey of(char symbol) {
        for (DtmfKey key : KEYS) {
            if (key.symbol == symbol) {
                return key;
            }
        }
        throw new IllegalArgumentException("expected one of 0123456789*#ABCD, found " + symbol);
    }

    /** The keys of a text, ignoring blanks; IllegalArgumentException for anything else. */
    public static List<DtmfKey> sequence(CharSequence text) {
        List<DtmfKey> keys = new ArrayList<>(text.length());
        for (int i = 0; i < text.length(); i++) {
            if (!Character.isWhitespace(text.charAt(i))) {
                keys.add(of(text.charAt(i)));
            }
        }
        return keys;
    }
}
