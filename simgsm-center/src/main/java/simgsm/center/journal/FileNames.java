package simgsm.center.journal;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What the journal's files are called. Segments are numbered upwards; a snapshot bears the number of the last segment
 * that it stands for.
 */
final class FileNames {
    private static final Pattern SEGMENT = Pattern.compile("segment-([0-9]{10})");
    private static final Pattern SNAPSHOT = Pattern.compile("snapshot-([0-9]{10})");
    private static final String UNFINISHED = "snapshot.unfinished";

    private FileNames() {}

    static String segment(long number) {
        return String.format("segment-%010d", number);
    }

    static String snapshot(long number) {
        return String.format("snapshot-%010d", number);
    }

    /** A snapshot while it is being written. */
    static String unfinished() {
        return UNFINISHED;
    }

    static Optional<Long> segmentNumber(String name) {
        return number(SEGMENT, name);
    }

    static Optional<Long> snapshotNumber(String name) {
        return number(SNAPSHOT, name);
    }

    /** Whether a snapshot with this number makes the file worthless. */
    static boolean isSuperseded(String name, long snapshot) {
        return segmentNumber(name).filter(number -> number <= snapshot).isPresent()
                || snapshotNumber(name).filter(number -> number < snapshot).isPresent();
    }

    private static Optional<Long> number(Pattern pattern, String name) {
        Matcher matcher = pattern.matcher(name);
        return matcher.matches() ? Optional.of(Long.parseLong(matcher.group(1))) : Optional.empty();
    }
}
