package simrobot.source;

/** A file that makes no process. */
final class SourceException extends Exception {
    private final int line;

    /** @param line of the source; 0 if unknown */
    SourceException(int line, String text) {
        super(text);
        this.line = line;
    }

    int line() {
        return line;
    }
}
