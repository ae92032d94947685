package simgsm.center.journal;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import simgsm.center.smsc.StoreEntry;

/** A file to which entries are appended. Its size counts durable octets; any after them are invalid. */
final class JournalSegment {
    private final DiskFile file;
    private long size;
    private long nextSequence = 1;

    JournalSegment(DiskFile file) {
        this.file = file;
    }

    long size() {
        return size;
    }

    /** Appends entries with one write and one synchronisation. */
    void append(List<StoreEntry> entries) throws IOException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        long sequence = nextSequence;
        for (StoreEntry entry : entries) {
            RecordFormat.write(octets, sequence++, EntryCodec.encode(entry));
        }
        file.write(ByteBuffer.wrap(octets.toByteArray()), size);
        file.sync();
        size += octets.size();
        nextSequence = sequence;
    }

    /** Removes the octets that a failed append may have left. */
    void repair() throws IOException {
        file.truncate(size);
        file.sync();
    }

    void close() throws IOException {
        file.close();
    }
}
