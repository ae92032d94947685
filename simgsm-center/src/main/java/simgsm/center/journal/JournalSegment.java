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

    /**
     * Appends entries with one write.
     *
     * @param isSynchronised true to make them durable now, not with a later append
     */
    void append(List<StoreEntry> entries, boolean isSynchronised) throws IOException {
        write(entries.stream().map(EntryCodec::encode).toList(), isSynchronised);
    }

    void append(FileMark mark) throws IOException {
        write(List.of(mark.encode()), true);
    }

    private void write(List<byte[]> contents, boolean isSynchronised) throws IOException {
        ByteArrayOutputStream octets = new ByteArrayOutputStream();
        long sequence = records;
        for (byte[] record : contents) {
            RecordFormat.write(octets, ++sequence, record);
        }
        if (size + octets.size() > capacity) {
            throw new IOException("the room held back is full");
        }
        file.write(ByteBuffer.wrap(octets.toByteArray()), size);
        if (isSynchronised) {
            file.sync();
        }
        size += octets.size();
        records = sequence;
    }

    /** Removes octets of a failed append. */
    void repair() throws IOException {
        file.truncate(size);
        file.sync();
    }

    void close() throws IOException {
        file.close();
    }
}
