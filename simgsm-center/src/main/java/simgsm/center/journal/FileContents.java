package simgsm.center.journal;

import java.util.Optional;

/** Information of a file's records about the file. */
final class FileContents {
    private long records;
    private long writtenRecords;
    private long previousRecords;
    private long cutOctets;
    private long goodOctets;
    private boolean isOpened;
    private boolean isClosed;

    void add(Optional<FileMark> mark) {
        records++;
        isClosed = false;
        if (mark.isPresent() && mark.get() instanceof FileMark.Opened opened) {
            isOpened = true;
            previousRecords = opened.previousRecords();
        } else if (mark.isPresent() && mark.get() instanceof FileMark.Closed closed) {
            isClosed = true;
            writtenRecords = closed.records() + 1;
        }
    }

    void ended(RecordReader reader) {
        writtenRecords = Math.max(writtenRecords, reader.writtenRecords());
        goodOctets = reader.goodEnd();
        cutOctets = reader.end() - goodOctets;
    }

    /** Number of records certainly written but missing. */
    long lostRecords() {
        return writtenRecords - records;
    }

    /** Number of records up to the last one present. */
    long writtenRecords() {
        return writtenRecords;
    }

    /** Number of records of the previous segment; 0 if the file has no such mark. */
    long previousRecords() {
        return previousRecords;
    }

    /** Octets after the last valid record. */
    long cutOctets() {
        return cutOctets;
    }

    /** True if the first mark is present. */
    boolean isOpened() {
        return isOpened;
    }

    /** True if the first mark is missing before entries: version 1.0.0 wrote none. */
    boolean isOfFirstFormat() {
        return !isOpened && records > 0;
    }

    /** True if the end mark is the last record. */
    boolean isClosed() {
        return isClosed;
    }

    /**
     * True if the octets at the end may be an interrupted write: the first record of a file is synchronised alone, so
     * at most that one can be torn at the file's start.
     */
    boolean isTornAsByDeath() {
        return records > 0 || goodOctets + cutOctets <= FileMark.RECORD_LENGTH;
    }
}
