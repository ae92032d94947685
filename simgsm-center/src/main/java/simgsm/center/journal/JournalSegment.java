package simgsm.center.journal;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.List;
import simgsm.center.smsc.StoreEntry;

/** A file to which records are appended. Its size counts durable octets; any after them are invalid. */
final class JournalSegment {
    private final DiskFile file;
    private final long capacity;
    private long size;
    private long records;

    private JournalSegment(DiskFile file, long capacity) {
        this.file = file;
        this.capacity = capacity;
    }

    /** Begins a new file with its mark; if that fails, the file is closed. @param file an empty file */
    static JournalSegment begin(DiskFile file, long previousRecords) throws IOException {
        return begin(file, previousRecords, Long.MAX_VALUE);
    }

    /** @param capacity octets that it may hold */
    static JournalSegment begin(DiskFile file, long previousRecords, long capacity) throws IOException {
        JournalSegment begun = new JournalSegment(file, capacity);
        try {
            begun.append(new FileMark.Opened(previousRecords));
            return begun;
        } catch (IOException e) {
            file.close();
            throw e;
        }
    }

    long size() {
        return size;
    }

    /** Durable records, marks included. */
    long records() {
        return records;
    }

    /** Appends entries with one write and one synchronisation. */
    void append(List<StoreEntry> entries) throws IOException {
        append(entries, true);
    }

    /** Appends entries that become durable with the next mark. */
    void appendUnsynchronised(List<StoreEntry> entries) throws IOException {
        append(entries, false);
    }

    private void append(List<StoreEntry> entries, boolean isSynchronised) throws IOException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        long sequence = records;
        for (StoreEntry entry : entries) {
            RecordFormat.write(octets, ++sequence, EntryCodec.encode(entry));
        }
        write(octets, sequence, isSynchronised);
    }

    void append(FileMark mark) throws IOException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        RecordFormat.write(octets, records + 1, mark.encode());
        write(octets, records + 1, true);
    }

    private void write(ByteArrayOutputStream octets, long lastSequence, boolean isSynchronised) throws IOException {
        if (size + octets.size() > capacity) {
            throw new IOException("the room held back is full");
        }
        file.write(ByteBuffer.wrap(octets.toByteArray()), size);
        if (isSynchronised) {
            file.sync();
        }
        size += octets.size();
        records = lastSequence;
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
