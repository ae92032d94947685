package simgsm.center.capture;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import simgsm.file.PrivateFiles;

/**
 * A classic pcap file, big-endian, microseconds. It always contains whole records, so that it can be opened at any
 * time.
 */
final class PcapFile {
    /** LINKTYPE_RAW: each packet begins with its IPv4 or IPv6 header. */
    private static final int LINK_TYPE_RAW = 101;

    private static final int MAGIC_MICROSECONDS = 0xa1b2c3d4;
    private static final short VERSION_MAJOR = 2;
    private static final short VERSION_MINOR = 4;
    private static final int SNAPSHOT_LENGTH = 65_535;
    private static final int HEADER_LENGTH = 24;

    private final Path path;
    private final FileChannel channel;
    /** Length of the whole records. */
    private long size;

    private PcapFile(Path path) throws IOException {
        this.path = path;
        this.channel = PrivateFiles.open(
                path, StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING, StandardOpenOption.WRITE);
    }

    static PcapFile create(Path path) throws IOException {
        PcapFile file = new PcapFile(path);
        ByteBuffer header = ByteBuffer.allocate(HEADER_LENGTH);
        header.putInt(MAGIC_MICROSECONDS).putShort(VERSION_MAJOR).putShort(VERSION_MINOR);
        header.putInt(0).putInt(0).putInt(SNAPSHOT_LENGTH).putInt(LINK_TYPE_RAW);
        try {
            file.write(header.flip());
        } catch (IOException e) {
            file.channel.close();
            throw e;
        }
        return file;
    }

    long size() {
        return size;
    }

    void write(PacketBuffer packets) throws IOException {
        write(packets.contents());
    }

    private void write(ByteBuffer octets) throws IOException {
        int count = octets.remaining();
        while (octets.hasRemaining()) {
            channel.write(octets);
        }
        size += count;
    }

    /** Renames this file, replacing an older one, and begins another. */
    PcapFile startAnew(Path aside) throws IOException {
        channel.close();
        Files.move(path, aside, StandardCopyOption.REPLACE_EXISTING);
        return create(path);
    }

    void close() throws IOException {
        channel.close();
    }

    /** Closes the file after a failure; truncates an incomplete record if possible. */
    void abandon() {
        try (channel) {
            channel.truncate(size);
        } catch (IOException e) {
            System.getLogger(PcapFile.class.getName())
                    .log(System.Logger.Level.DEBUG, "cutting {0}: {1}", path, e.getMessage());
        }
    }
}
