package simgsm.sms;

import java.util.ArrayList;
import java.util.List;

/** Divides a text into the fewest user parts, in the alphabet with the fewest octets that codes it without loss. */
public final class MessageSplitter {
    /**
     * The size of a text, for the counter of a text field.
     *
     * @param parts 1 to 255; more if the text is too long to send
     * @param unitsLeft units that still fit into the last part
     */
    public record Measure(Alphabet alphabet, int parts, int unitsLeft) {}

    private MessageSplitter() {}

    /** The size of a text. */
    public static Measure measure(String text) {
        Alphabet alphabet = Alphabet.of(text);
        int units = units(text, alphabet);
        if (units <= alphabet.unitsInOnePart()) {
            return new Measure(alphabet, 1, alphabet.unitsInOnePart() - units);
        }
        List<String> pieces = pieces(text, alphabet, alphabet.unitsInEachOfMany());
        int last = units(pieces.get(pieces.size() - 1), alphabet);
        return new Measure(alphabet, pieces.size(), alphabet.unitsInEachOfMany() - last);
    }

    /**
     * The parts in order; a text that fits into one part has no header.
     *
     * @param reference 0 to 255, a new one for each message to the same receiver
     * @throws IllegalArgumentException for a text of more than 255 parts
     */
    public static List<UserData> split(String text, int reference) {
        Alphabet alphabet = Alphabet.of(text);
        if (units(text, alphabet) <= alphabet.unitsInOnePart()) {
            return List.of(UserData.of(text, alphabet, new byte[0]));
        }
        List<String> pieces = pieces(text, alphabet, alphabet.unitsInEachOfMany());
        if (pieces.size() > Concatenation.MAX_PARTS) {
            throw new IllegalArgumentException(
                    "the text needs " + pieces.size() + " parts, at most " + Concatenation.MAX_PARTS + " can be sent");
        }
        List<UserData> parts = new ArrayList<>(pieces.size());
        for (String piece : pieces) {
            Concatenation place = new Concatenation(reference & 0xff, pieces.size(), parts.size() + 1);
            parts.add(UserData.of(piece, alphabet, UserDataHeader.of(place)));
        }
        return parts;
    }

    static int units(String text, Alphabet alphabet) {
        return alphabet == Alphabet.GSM_7BIT
                ? text.chars()
                        .map(character -> GsmAlphabet.septetCount((char) character))
                        .sum()
                : text.length();
    }

    /** Pieces of at most this many units, never split between an escape and its code or inside a surrogate pair. */
    static List<String> pieces(String text, Alphabet alphabet, int unitsInEach) {
        List<String> pieces = new ArrayList<>();
        int start = 0;
        int used = 0;
        for (int i = 0; i < text.length(); i += symbolLength(text, i)) {
            String symbol = text.substring(i, i + symbolLength(text, i));
            int units = units(symbol, alphabet);
            if (used + units > unitsInEach) {
                pieces.add(text.substring(start, i));
                start = i;
                used = 0;
            }
            used += units;
        }
        pieces.add(text.substring(start));
        return pieces;
    }

    private static int symbolLength(String text, int index) {
        return Character.charCount(text.codePointAt(index));
    }
}
