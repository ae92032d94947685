package vericommand;

/**
 * Finds {@code *#} outside an order, by which a caller asks to be heard. The star of {@code **#} belongs to an order, that
 * of {@code #*#} to a broken one.
 */
final class ListeningRequest {
    private char before;
    private boolean isStarAlone;

    /** @param isOpen true if the key is within an order */
    boolean key(char key, boolean isOpen) {
        boolean isAsked = isStarAlone && key == '#' && !isOpen;
        isStarAlone = key == '*' && !isOpen && before != '*' && before != '#';
        boolean isOfOrder = isOpen && key == '*';
        before = isOfOrder || isAsked ? ' ' : key;
        return isAsked;
    }

    /** The call has ended. */
    void reset() {
        before = ' ';
        isStarAlone = false;
    }
}
