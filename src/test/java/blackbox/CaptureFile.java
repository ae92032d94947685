package blackbox;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A pcap file as an outsider reads it, by the format's own description and by RFC 768, 791 and 9293. Whatever does not hold
 * is an AssertionError that names the record.
 */
public final class CaptureFile {
    private static final int MAGIC = 0xa1b2c3d4;
    private static final int RAW_IP = 101;
    private static final int TCP = 6;
    private static final int UDP = 17;
    private static final int SYN_OR_FIN = 3;
    private static final int SYN = 2;

    /** One TCP segment. */
    public record Segment(
            long micros, int fromPort, int toPort, int sequence, int acknowledged, int flags, byte[] data) {
        boolean isSyn() {
            return (flags & SYN) != 0;
        }
    }

    /** One UDP datagram. */
    public record Datagram(int fromPort, int toPort, byte[] data) {}

    private final List<Segment> segments = new ArrayList<>();
    private final List<Datagram> datagrams = new ArrayList<>();

    public static CaptureFile read(Path file) throws IOException {
        CaptureFile capture = new CaptureFile();
        ByteBuffer in = ByteBuffer.wrap(Files.readAllBytes(file));
        require(in.getInt() == MAGIC, "the magic number of microseconds");
        require(in.getShort() == 2 && in.getShort() == 4, "version 2.4");
        in.getLong();
        in.getInt();
        require(in.getInt() == RAW_IP, "link type raw IP");
        while (in.hasRemaining()) {
            capture.record(in);
        }
        return capture;
    }

    private void record(ByteBuffer in) {
        String where = "record " + (segments.size() + datagrams.size() + 1) + ": ";
        require(in.remaining() >= 16, where + "a whole record header");
        long micros = in.getInt() * 1_000_000L + in.getInt();
        int length = in.getInt();
        require(length == in.getInt() && length <= in.remaining(), where + "a whole packet");
        byte[] packet = new byte[length];
        in.get(packet);
        packet(micros, ByteBuffer.wrap(packet), where);
    }

    private void packet(long micros, ByteBuffer packet, String where) {
        int length = packet.capacity();
        require(packet.get(0) == 0x45, where + "IPv4 without options");
        require(packet.getShort(2) == length, where + "the packet's length in its header");
        int protocol = packet.get(9);
        require(protocol == TCP || protocol == UDP, where + "TCP or UDP");
        require(sum(packet, 0, 20, 0) == 0xffff, where + "the header's checksum");
        long pseudoHeader = sum(packet, 12, 8, protocol + length - 20);
        require(sum(packet, 20, length - 20, pseudoHeader) == 0xffff, where + "the segment's checksum");
        packet.position(20);
        if (protocol == TCP) {
            segments.add(segment(micros, packet, where));
        } else {
            datagrams.add(datagram(packet, where));
        }
    }

    private static Datagram datagram(ByteBuffer packet, String where) {
        int fromPort = packet.getShort() & 0xffff;
        int toPort = packet.getShort() & 0xffff;
        require(packet.getShort() == packet.capacity() - 20, where + "the datagram's length in its header");
        byte[] data = new byte[packet.capacity() - 28];
        packet.get(28, data);
        return new Datagram(fromPort, toPort, data);
    }

    private static Segment segment(long micros, ByteBuffer packet, String where) {
        int fromPort = packet.getShort() & 0xffff;
        int toPort = packet.getShort() & 0xffff;
        int sequence = packet.getInt();
        int acknowledged = packet.getInt();
        require(packet.get() == 0x50, where + "TCP without options");
        int flags = packet.get();
        packet.position(40);
        byte[] data = new byte[packet.capacity() - 40];
        packet.get(data);
        return new Segment(micros, fromPort, toPort, sequence, acknowledged, flags, data);
    }

    private static long sum(ByteBuffer octets, int from, int length, long begin) {
        long sum = begin;
        for (int i = 0; i < length; i++) {
            sum += (octets.get(from + i) & 0xff) << (i % 2 == 0 ? 8 : 0);
        }
        while (sum > 0xffff) {
            sum = (sum & 0xffff) + (sum >> 16);
        }
        return sum;
    }

    private static void require(boolean holds, String what) {
        if (!holds) {
            throw new AssertionError("expected " + what);
        }
    }

    /** The speech. */
    public List<Datagram> datagrams() {
        return datagrams;
    }

    public List<Segment> segments() {
        return segments;
    }

    /** Each side's sequence numbers follow on one another, only sent octets are acknowledged, and time does not go back. */
    public void requireOrder() {
        Map<String, Integer> next = new HashMap<>();
        long latest = 0;
        for (int i = 0; i < segments.size(); i++) {
            Segment segment = segments.get(i);
            String where = "record " + (i + 1) + ": ";
            String from = segment.fromPort + ">" + segment.toPort;
            String to = segment.toPort + ">" + segment.fromPort;
            require(segment.fromPort == 3003 || segment.toPort == 3003, where + "port 3003 at one side");
            if (segment.isSyn()) {
                next.put(from, segment.sequence);
            }
            require(next.get(from) != null && next.get(from) == segment.sequence, where + "the next sequence number");
            int told = next.getOrDefault(to, 0);
            require(told - segment.acknowledged >= 0 && told - segment.acknowledged < 65_536, where + "what was said");
            next.merge(from, segment.data.length + ((segment.flags & SYN_OR_FIN) != 0 ? 1 : 0), Integer::sum);
            require(segment.micros >= latest, where + "a time that does not go back");
            latest = segment.micros;
        }
    }

    /** Every segment with data holds one whole IPA frame. */
    public void requireWholeFrames() {
        for (int i = 0; i < segments.size(); i++) {
            byte[] data = segments.get(i).data;
            require(
                    data.length == 0 || data.length == 3 + ((data[0] & 0xff) << 8 | data[1] & 0xff),
                    "record " + (i + 1) + ": one IPA frame");
        }
    }

    /** How many frames of an IPA stream there are. */
    public long frames(int stream) {
        return segments.stream()
                .filter(segment -> segment.data.length > 0 && (segment.data[2] & 0xff) == stream)
                .count();
    }
}
