package simgsm.center.journal;

import java.io.IOException;
import java.nio.ByteBuffer;

/** An open file. */
public interface DiskFile extends AutoCloseable {
    long size() throws IOException;

    /** Reads until the buffer is full or the file ends. */
    void read(ByteBuffer into, long position) throws IOException;

    /** Writes all that remains in the buffer. */
    void write(ByteBuffer octets, long position) throws IOException;

    void truncate(long size) throws IOException;

    /** Makes all writes durable. After a failure the state of the writes since the last success is unknown. */
    void sync() throws IOException;

    @Override
    void close() throws IOException;
}
