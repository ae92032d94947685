package simgsm.center.journal;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.function.Consumer;

/** Reads a file's records in order; octets between valid records are reported and skipped. */
final class RecordReader {
    /** Window of at least 256 KiB: several of the longest records. */
    private static final int WINDOW = 4 * (RecordFormat.HEADER_LENGTH + RecordFormat.MAX_CONTENTS);

    private static final long NONE = -1;

    private final String name;
    private final DiskFile file;
    private final long size;
    private final Consumer<Damage> damages;
    private final ByteBuffer window = ByteBuffer.allocate(WINDOW);
    private long windowStart;
    private long position;
    private long lastSequence = NONE;
    private long damagedFrom = NONE;
    /** True if all octets since {@link #damagedFrom} are 0: unused space of a segment. */
    private boolean isBlank;

    private long records;
    private long end;

    RecordReader(String name, DiskFile file, Consumer<Damage> damages) throws IOException {
        this.name = name;
        this.file = file;
        this.damages = damages;
        this.size = file.size();
        window.limit(0);
    }

    /** The contents of the next valid record, or null at the end. */
    byte[] next() throws IOException {
        while (position < size) {
            byte[] contents = contentsHere();
            if (contents != null) {
                reportDamage(false);
                position += RecordFormat.HEADER_LENGTH + contents.length;
                records++;
                return contents;
            }
            isBlank = (damagedFrom == NONE || isBlank) && load(1) && window.get((int) (position - windowStart)) == 0;
            damagedFrom = damagedFrom == NONE ? position : damagedFrom;
            position++;
        }
        reportDamage(true);
        return null;
    }

    /** Valid records so far. */
    long records() {
        return records;
    }

    /** Number of records in the file up to the last valid one: {@link #records} and those lost before it. */
    long writtenRecords() {
        return Math.max(0, lastSequence);
    }

    /** The position after the last valid record so far. */
    long goodEnd() {
        return damagedFrom == NONE ? position : damagedFrom;
    }

    /** The end of the records and of the damage after them; valid after reading everything. */
    long end() {
        return end;
    }

    private void reportDamage(boolean isTail) {
        end = size;
        if (damagedFrom != NONE) {
            if (isTail && isBlank) {
                end = damagedFrom;
            } else {
                damages.accept(new Damage(name, damagedFrom, position, isTail));
            }
            position = isTail ? damagedFrom : position;
            damagedFrom = NONE;
        }
    }

    private byte[] contentsHere() throws IOException {
        if (!load(RecordFormat.HEADER_LENGTH) || at(0) != RecordFormat.MARK) {
            return null;
        }
        int length = at(4);
        boolean isPossible = length > 0 && length <= RecordFormat.MAX_CONTENTS;
        if (!isPossible || !load(RecordFormat.HEADER_LENGTH + length)) {
            return null;
        }
        int start = (int) (position - windowStart);
        long sequence = window.getLong(start + 12);
        byte[] contents = new byte[length];
        window.get(start + RecordFormat.HEADER_LENGTH, contents);
        if (at(8) != RecordFormat.checksum(length, sequence, ByteBuffer.wrap(contents)) || sequence <= lastSequence) {
            return null;
        }
        lastSequence = sequence;
        return contents;
    }

    private int at(int offset) {
        return window.getInt((int) (position - windowStart) + offset);
    }

    /** Reads this number of octets from the position on into the window; false if the file is shorter. */
    private boolean load(int length) throws IOException {
        if (position + length > size) {
            return false;
        }
        if (position + length > windowStart + window.limit()) {
            window.clear();
            windowStart = position;
            file.read(window, position);
            window.flip();
        }
        return position + length <= windowStart + window.limit();
    }
}
