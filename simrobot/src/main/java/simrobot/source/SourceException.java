package simrobot.source;

/** A file from which no process can be made. */
final class SourceException extends Exception {
    private final int line;

    /** @param line of the source; 0 if the fault belongs to none */
    SourceException(int line, String text) {
        super(text);
        this.line = line;
    }

    int line() {
        return line;
    }
}
