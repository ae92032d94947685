package simrobot.world;

import java.io.IOException;

/** A world file says something that cannot be read; the message names file, line, what was found and what was expected. */
public final class WorldFormatException extends IOException {
    private final int line;

    WorldFormatException(String source, int line, String found, String expected) {
        super(source + ":" + line + ": found " + found + ", expected " + expected);
        this.line = line;
    }

    /** Counted from 1. */
    public int line() {
        return line;
    }
}
