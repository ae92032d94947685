package simgsm.cells.town;

import java.io.IOException;

/** A town file cannot be read; the message names file, line, the text found and the expected one. */
public final class TownFormatException extends IOException {
    private final int line;

    TownFormatException(String source, int line, String found, String expected) {
        super(source + ":" + line + ": found " + found + ", expected " + expected);
        this.line = line;
    }

    /** Counted from 1. */
    public int line() {
        return line;
    }
}
