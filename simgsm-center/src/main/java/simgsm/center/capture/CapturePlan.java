package simgsm.center.capture;

import java.nio.file.Path;

/**
 * File and limit of a capture.
 *
 * @param file overwritten if it exists
 * @param limitOctets length after which the file is renamed to {@link #previous()}, and a new one begun
 */
public record CapturePlan(Path file, long limitOctets) {
    public static final int DEFAULT_LIMIT_MIB = 1024;
    public static final int LARGEST_LIMIT_MIB = 1024 * 1024;

    private static final long OCTETS_PER_MIB = 1024 * 1024;

    /** @param limitMib 1 to {@link #LARGEST_LIMIT_MIB} */
    public static CapturePlan of(Path file, long limitMib) {
        return new CapturePlan(file, limitMib * OCTETS_PER_MIB);
    }

    /** The name of the last full part: {@code lesson.1.pcap} of {@code lesson.pcap}. */
    Path previous() {
        String name = file.getFileName().toString();
        int dot = name.lastIndexOf('.');
        String previous = dot > 0 ? name.substring(0, dot) + ".1" + name.substring(dot) : name + ".1";
        return file.resolveSibling(previous);
    }
}
