package simgsm.center.journal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Set;

/**
 * A file of zeros that becomes the next segment when the disk is full, so that the ends of messages are recorded and
 * none is delivered twice. It is written in place, so no other file can take its space.
 */
final class DiskReserve {
    private static final int PIECE = 64 * 1024;

    private final Disk disk;
    /** Null if there is none. */
    private DiskFile file;

    private long size;
    private long wanted;

    /** Opens the reserve of an earlier process, if there is one. @throws IOException if another process holds it */
    DiskReserve(Disk disk, Set<String> names) throws IOException {
        this.disk = disk;
        if (names.contains(FileNames.reserve())) {
            file = disk.open(FileNames.reserve());
            size = file.size();
        }
    }

    /** @param octets target size of {@link #isFilled}; 0 at first */
    void hold(long octets) {
        wanted = octets;
    }

    long size() {
        return size;
    }

    /**
     * Adds missing octets if the disk has space.
     *
     * @return true if the reserve is complete
     */
    boolean isFilled() {
        try {
            if (file == null && wanted > 0) {
                file = disk.create(FileNames.reserve());
            }
            while (size < wanted) {
                int count = (int) Math.min(PIECE, wanted - size);
                file.write(ByteBuffer.allocate(count), size);
                size += count;
            }
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    /** Converts it to a segment of its size. */
    JournalSegment become(String name, long previousRecords) throws IOException {
        if (size == 0) {
            throw new IOException("no room is held back");
        }
        disk.rename(FileNames.reserve(), name);
        DiskFile room = file;
        long capacity = size;
        file = null;
        size = 0;
        JournalSegment begun = JournalSegment.begin(room, previousRecords, capacity);
        disk.sync();
        return begun;
    }

    void close() {
        DiskFile closing = file;
        file = null;
        if (closing != null) {
            try {
                closing.close();
            } catch (IOException e) {
                // nothing is lost: it contains zeros
            }
        }
    }
}
