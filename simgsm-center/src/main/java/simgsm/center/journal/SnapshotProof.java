package simgsm.center.journal;

import java.io.IOException;

/** Verifies a snapshot in steps: no damage, and the end mark with the right count. */
final class SnapshotProof implements AutoCloseable {
    private final DiskFile file;
    private final RecordReader reader;
    private boolean isUndamaged = true;
    private boolean hasBegun;
    private boolean isEnded;

    SnapshotProof(String name, DiskFile file) throws IOException {
        this.file = file;
        this.reader = new RecordReader(name, file, damage -> isUndamaged = false);
    }

    /** True if the snapshot is whole; reads all of it. */
    static boolean isWhole(Disk disk, String name) throws IOException {
        try (SnapshotProof proof = new SnapshotProof(name, disk.open(name))) {
            return proof.read(Long.MAX_VALUE) && proof.isWhole();
        }
    }

    /**
     * Reads at most this number of records.
     *
     * @return true at the end
     */
    boolean read(long records) throws IOException {
        for (long i = 0; i < records; i++) {
            byte[] contents = reader.next();
            if (contents == null) {
                return true;
            }
            FileMark mark = FileMark.decode(contents).orElse(null);
            boolean isFirst = reader.records() == 1;
            hasBegun |= isFirst && mark instanceof FileMark.Opened;
            // a record after the end mark revokes it
            isEnded = mark instanceof FileMark.Closed closed && closed.records() == reader.records() - 1;
        }
        return false;
    }

    /** The result after the last record. */
    boolean isWhole() {
        return isUndamaged && hasBegun && isEnded;
    }

    @Override
    public void close() throws IOException {
        file.close();
    }
}
