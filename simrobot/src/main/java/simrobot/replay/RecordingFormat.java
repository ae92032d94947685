package simrobot.replay;

/**
 * The file, all numbers big endian:
 *
 * <pre>
 *   file    = "SimRobot" version(2 octets) stepNanos(8) { record }
 *   record  = length(4) kind(1) content(length) checksum(4)     CRC-32C over kind and content
 *   kinds   = WORLD   a world ({@link WorldCodec})
 *             CAST    the robots' names in their order, from here on
 *             KEY     begin(8) end(8) entries: every robot's whole state first, so that reading may begin here
 *             CHANGES begin(8) end(8) entries: goes on where the record before it ended
 *             EVENTS  what happened meanwhile: {@link RecordedEvent}s
 * </pre>
 *
 * Contents of a kind with {@link #DEFLATED} added are deflated (RFC 1951). Records are only ever added, so a file whose
 * writer was killed is whole up to its last record but one.
 */
final class RecordingFormat {
    static final String MAGIC = "SimRobot";
    static final int VERSION = 1;
    static final int HEADER_OCTETS = MAGIC.length() + 2 + 8;
    static final int DEFLATED = 0x80;

    /** Length, kind and checksum. */
    static final int FRAME_OCTETS = 4 + 1 + 4;

    /** Far above what a writer makes; a longer one is damage. */
    static final int MAX_CONTENT_OCTETS = 256 << 20;

    enum Kind {
        WORLD,
        CAST,
        KEY,
        CHANGES,
        EVENTS
    }

    // the entries of KEY and CHANGES, by their lowest two bits; the rest is a number
    /** So many steps in which nothing changed. */
    static final int IDLE_STEPS = 0;
    /** One step, then this many robots that changed in it. */
    static final int STEP = 1;
    /** No time passes, and this many robots changed. */
    static final int IN_PLACE = 2;

    private RecordingFormat() {}
}
