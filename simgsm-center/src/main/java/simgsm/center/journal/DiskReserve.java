package simgsm.center.journal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.Set;

/**
 * A file of zeros that becomes the next segment when the disk is full, so that the ends of messages are recorded and none is
 * delivered twice. It is written in place: no other file can take its room.
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

    /** @param octets to be held by {@link #isFilled}; 0 at first */
    void hold(long octets) {
        wanted = octets;
    }

    long size() {
        return size;
    }

    /** Takes the octets that are missing, as far as the disk has them. @return whether it holds all */
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

    /** Makes it a segment as large as the room. */
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
                // Nothing is lost: it holds zeros.
            }
        }
    }
}
