package simgsm.center.journal;

import java.nio.ByteBuffer;
import java.util.Optional;

/**
 * Records about the file itself: the first of every file, and the last of a snapshot. Files of version 1.0.0 have none.
 * The first octet is the kind, different from those of {@link EntryCodec}.
 */
sealed interface FileMark {
    /**
     * The first record of a file.
     *
     * @param previousRecords records in the previous segment, to verify its end; 0 if there is none
     */
    record Opened(long previousRecords) implements FileMark {
        @Override
        public byte[] encode() {
            return FileMark.encode(OPENED, previousRecords);
        }
    }

    /**
     * The last record of a snapshot.
     *
     * @param records before this one
     */
    record Closed(long records) implements FileMark {
        @Override
        public byte[] encode() {
            return FileMark.encode(CLOSED, records);
        }
    }

    int OPENED = 6;
    int CLOSED = 7;
    /** Octets of a mark with its record header. */
    int RECORD_LENGTH = RecordFormat.HEADER_LENGTH + 1 + Long.BYTES;

    byte[] encode();

    private static byte[] encode(int kind, long number) {
        return ByteBuffer.allocate(1 + Long.BYTES)
                .put((byte) kind)
                .putLong(number)
                .array();
    }

    /** The mark in a record's contents; empty for an entry. */
    static Optional<FileMark> decode(byte[] contents) {
        if (contents.length != 1 + Long.BYTES) {
            return Optional.empty();
        }
        long number = ByteBuffer.wrap(contents).getLong(1);
        return switch (contents[0]) {
            case OPENED -> Optional.of(new Opened(number));
            case CLOSED -> Optional.of(new Closed(number));
            default -> Optional.empty();
        };
    }
}
