package simgsm.phone.screen;

import java.util.Optional;
import simgsm.dtmf.DtmfKey;

/** The keys of the handset. Twelve make tones; the letters are those of ITU-T E.161. */
public enum PhoneKey {
    ONE('1', ""),
    TWO('2', "abc"),
    THREE('3', "def"),
    FOUR('4', "ghi"),
    FIVE('5', "jkl"),
    SIX('6', "mno"),
    SEVEN('7', "pqrs"),
    EIGHT('8', "tuv"),
    NINE('9', "wxyz"),
    STAR('*', ""),
    ZERO('0', "+"),
    HASH('#', ""),
    /** The keys under the display, which names their functions. */
    SOFT_LEFT,
    SOFT_RIGHT,
    CALL,
    END,
    UP,
    DOWN,
    LEFT,
    RIGHT,
    OK,
    MESSAGE,
    MENU,
    /** Erases the character before the cursor. */
    CLEAR;

    private final Optional<DtmfKey> tone;
    private final String letters;

    PhoneKey() {
        tone = Optional.empty();
        letters = "";
    }

    PhoneKey(char symbol, String letters) {
        tone = Optional.of(DtmfKey.of(symbol));
        this.letters = letters;
    }

    /** The tone of one of the twelve keys. */
    public Optional<DtmfKey> tone() {
        return tone;
    }

    /** The letters printed on the key. */
    public String letters() {
        return letters;
    }

    /** The key for a symbol of {@code 0-9*#}, if it is one. */
    public static Optional<PhoneKey> ofSymbol(char symbol) {
        for (PhoneKey key : values()) {
            if (key.tone.isPresent() && key.tone.get().symbol() == symbol) {
                return Optional.of(key);
            }
        }
        return Optional.empty();
    }
}
