package simgsm.center.journal;

import java.util.Optional;

/** What a file's records say of the file. */
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

    /** Records that are known to have been written and are not there. */
    long lostRecords() {
        return writtenRecords - records;
    }

    /** Records up to the last that is there. */
    long writtenRecords() {
        return writtenRecords;
    }

    /** Records of the segment before; 0 if the file does not say. */
    long previousRecords() {
        return previousRecords;
    }

    /** Octets after the last valid record. */
    long cutOctets() {
        return cutOctets;
    }

    /** Whether the first mark is there. */
    boolean isOpened() {
        return isOpened;
    }

    /** Whether the first mark is missing and entries are there: version 1.0.0 wrote none. */
    boolean isOfFirstFormat() {
        return !isOpened && records > 0;
    }

    /** Whether the end mark is the last record. */
    boolean isClosed() {
        return isClosed;
    }

    /**
     * Whether the process may have died while it wrote the octets at the end: the first record of a file is synchronised
     * alone, so at most that one can be torn at the file's start.
     */
    boolean isTornAsByDeath() {
        return records > 0 || goodOctets + cutOctets <= FileMark.RECORD_LENGTH;
    }
}
