package simgsm.phone.screen;

/** A text with a cursor. */
final class LineEditor {
    private final int most;
    private final StringBuilder text = new StringBuilder();
    private int caret;

    /** @param most characters */
    LineEditor(int most) {
        this.most = most;
    }

    String text() {
        return text.toString();
    }

    /** The number of characters before the cursor. */
    int caret() {
        return caret;
    }

    boolean isEmpty() {
        return text.length() == 0;
    }

    /** Replaces the text and moves the cursor to its end. */
    void set(String next) {
        text.setLength(0);
        text.append(next, 0, Math.min(most, next.length()));
        caret = text.length();
    }

    /** Inserts a character at the cursor. @return false if the text is full */
    boolean insert(char character) {
        if (text.length() == most) {
            return false;
        }
        text.insert(caret++, character);
        return true;
    }

    /** Erases the character before the cursor, including both halves of a surrogate pair. */
    void erase() {
        int from = caret - length(caret);
        text.delete(from, caret);
        caret = from;
    }

    void left() {
        caret -= length(caret);
    }

    void right() {
        boolean isPair =
                caret + 1 < text.length() && Character.isSurrogatePair(text.charAt(caret), text.charAt(caret + 1));
        caret = Math.min(text.length(), caret + (isPair ? 2 : 1));
    }

    /** Number of UTF-16 units of the character before the place. */
    private int length(int place) {
        boolean isPair = place > 1 && Character.isSurrogatePair(text.charAt(place - 2), text.charAt(place - 1));
        return isPair ? 2 : Math.min(1, place);
    }
}
