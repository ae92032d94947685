package simgsm.center.journal;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Names of the journal's files. Segments are numbered from 1; a snapshot has the number of the last segment it replaces. */
final class FileNames {
    private static final Pattern SEGMENT = Pattern.compile("segment-([0-9]{10})");
    private static final Pattern SNAPSHOT = Pattern.compile("snapshot-([0-9]{10})");
    private static final String UNFINISHED = "snapshot.unfinished";

    private FileNames() {}

    static String segment(long number) {
        return String.format(Locale.ROOT, "segment-%010d", number);
    }

    static String snapshot(long number) {
        return String.format(Locale.ROOT, "snapshot-%010d", number);
    }

    /** A snapshot while it is being written. */
    static String unfinished() {
        return UNFINISHED;
    }

    /** The space reserved for the ends of messages. */
    static String reserve() {
        return "reserve";
    }

    /** The copy of a file's unreadable octets from this position on. */
    static String damaged(String name, long from) {
        return name + "-" + from + ".damaged";
    }

    static Optional<Long> segmentNumber(String name) {
        return number(SEGMENT, name);
    }

    static Optional<Long> snapshotNumber(String name) {
        return number(SNAPSHOT, name);
    }

    /** True if a snapshot with this number replaces the file. */
    static boolean isSuperseded(String name, long snapshot) {
        return segmentNumber(name).filter(number -> number <= snapshot).isPresent()
                || snapshotNumber(name).filter(number -> number < snapshot).isPresent();
    }

    private static Optional<Long> number(Pattern pattern, String name) {
        Matcher matcher = pattern.matcher(name);
        return matcher.matches() ? Optional.of(Long.parseLong(matcher.group(1))) : Optional.empty();
    }
}
