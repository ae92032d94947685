package simrobot.world;

import java.io.IOException;

/** A world file cannot be read; the message names file, line, the text found and the expected one. */
public final class WorldFormatException extends IOException {
    private final String source;
    private final int line;
    private final String found;
    private final String expected;

    WorldFormatException(String source, int line, String found, String expected) {
        super(source + ":" + line + ": found " + found + ", expected " + expected);
        this.source = source;
        this.line = line;
        this.found = found;
        this.expected = expected;
    }

    /** The file's name. */
    public String source() {
        return source;
    }

    /** The text found, in quotes if it is the file's. */
    public String found() {
        return found;
    }

    /** The expected text. */
    public String expected() {
        return expected;
    }

    /** Counted from 1. */
    public int line() {
        return line;
    }
}
