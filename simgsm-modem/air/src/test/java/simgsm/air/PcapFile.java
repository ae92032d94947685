package simgsm.air;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import simgsm.octets.OctetWriter;

/** A capture file of one TCP connection between a terminal and port 3003, as loopback would show it. */
public final class PcapFile {
    private static final int RAW_IPV4 = 228;
    private static final int CENTER_PORT = 3003;
    private static final int TERMINAL_PORT = 40000;
    private static final int IP_AND_TCP_HEADERS = 40;

    private final ByteArrayOutputStream file = new ByteArrayOutputStream();
    private long uplinkSequence = 1;
    private long downlinkSequence = 1;
    private int packets;

    public PcapFile() {
        little(0xa1b2c3d4).little(2 | 4 << 16).little(0).little(0).little(65535).little(RAW_IPV4);
    }

    public PcapFile add(byte[] segment, Direction direction) {
        boolean up = direction == Direction.UPLINK;
        int length = IP_AND_TCP_HEADERS + segment.length;
        little(packets++).little(0).little(length).little(length);
        OctetWriter out = new OctetWriter();
        out.octet(0x45).octet(0).twoOctets(length).twoOctets(packets).twoOctets(0x4000);
        out.octet(64).octet(6).twoOctets(0).fourOctets(0x7f000001).fourOctets(0x7f000001);
        out.twoOctets(up ? TERMINAL_PORT : CENTER_PORT).twoOctets(up ? CENTER_PORT : TERMINAL_PORT);
        out.fourOctets(up ? uplinkSequence : downlinkSequence).fourOctets(up ? downlinkSequence : uplinkSequence);
        out.twoOctets(0x5018).twoOctets(65535).fourOctets(0).bytes(segment);
        file.writeBytes(out.toArray());
        uplinkSequence += up ? segment.length : 0;
        downlinkSequence += up ? 0 : segment.length;
        return this;
    }

    void write(Path path) throws IOException {
        Files.write(path, file.toByteArray());
    }

    private PcapFile little(int value) {
        for (int shift = 0; shift < 32; shift += 8) {
            file.write(value >> shift);
        }
        return this;
    }
}
