package simrobot.source;

import java.util.Locale;

/**
 * Settings of children.
 *
 * @param memoryMebibytes the heap of each
 * @param hints for faults, in the user's language
 */
public record ChildSettings(int memoryMebibytes, Hints hints) {
    public static final int MIN_MEBIBYTES = 8;
    public static final int DEFAULT_MEBIBYTES = 64;
    public static final int MAX_MEBIBYTES = 4096;

    public static ChildSettings of(int memoryMebibytes, Locale language) {
        return new ChildSettings(memoryMebibytes, new Hints(language));
    }
}
