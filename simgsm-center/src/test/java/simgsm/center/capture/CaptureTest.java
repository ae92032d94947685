package simgsm.center.capture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simgsm.abis.IpaFrame;
import simgsm.abis.IpaFramer;

class CaptureTest {
    private static final int FILE_HEADER = 24;
    private static final int TCP_ACKNOWLEDGED = 8;
    private static final int TCP_FLAGS = 13;
    private static final int TCP_HEADER = 20;

    @TempDir
    Path folder;

    private static InetSocketAddress address(String host, int port) throws IOException {
        return new InetSocketAddress(InetAddress.getByName(host), port);
    }

    private static WireTap conversation(Capture capture) throws IOException {
        return capture.conversation(address("127.0.0.2", 40_000), address("127.0.0.1", 5_000));
    }

    private static List<ByteBuffer> packets(Path file) throws IOException {
        ByteBuffer in = ByteBuffer.wrap(Files.readAllBytes(file)).position(FILE_HEADER);
        List<ByteBuffer> packets = new ArrayList<>();
        while (in.hasRemaining()) {
            int length = in.getInt(in.position() + 8);
            packets.add(in.slice(in.position() + 16, length));
            in.position(in.position() + 16 + length);
        }
        return packets;
    }

    private static byte[] data(ByteBuffer packet, int ipHeader) {
        byte[] data = new byte[packet.capacity() - ipHeader - TCP_HEADER];
        packet.get(ipHeader + TCP_HEADER, data);
        return data;
    }

    @Test
    void aMessageIsASegmentBetweenHandshakeAndEnd() throws IOException {
        Path file = folder.resolve("a.pcap");
        try (Capture capture = Capture.start(CapturePlan.of(file, 1))) {
            WireTap tap = conversation(capture);
            tap.received(new IpaFrame(IpaFrame.CCM, new byte[] {0}));
            tap.sent(new byte[] {0, 1, (byte) 0xfe, 1});
            tap.closed(true);
            tap.closed(false);
            tap.sent(new byte[] {1});
        }
        List<ByteBuffer> packets = packets(file);
        assertEquals(8, packets.size());
        assertArrayEquals(new byte[] {0, 1, (byte) 0xfe, 0}, data(packets.get(3), 20));
        assertArrayEquals(new byte[] {0, 1, (byte) 0xfe, 1}, data(packets.get(4), 20));
        assertEquals(40_000, packets.get(3).getShort(20) & 0xffff);
        assertEquals(3003, packets.get(3).getShort(22));
        assertEquals(3003, packets.get(4).getShort(20));
        assertEquals(0x02, packets.get(0).get(20 + TCP_FLAGS), "SYN");
        assertEquals(0x12, packets.get(1).get(20 + TCP_FLAGS), "SYN and ACK");
        assertEquals(0x11, packets.get(5).get(20 + TCP_FLAGS), "FIN and ACK");
        assertEquals(40_000, packets.get(5).getShort(20) & 0xffff, "the peer left first");
    }

    @Test
    void whoOnlyTalksIsAcknowledgedBeforeTheWindowIsFull() throws IOException {
        Path file = folder.resolve("a.pcap");
        int frames = 1_000;
        try (Capture capture = Capture.start(CapturePlan.of(file, 10))) {
            WireTap tap = conversation(capture);
            for (int i = 0; i < frames; i++) {
                tap.sent(new byte[175]);
            }
        }
        int said = 1;
        int acknowledged = 1;
        for (ByteBuffer packet : packets(file).subList(3, packets(file).size())) {
            if (packet.getShort(20) == 3003) {
                assertEquals(said, packet.getInt(20 + 4));
                said += data(packet, 20).length;
            } else {
                acknowledged = packet.getInt(20 + TCP_ACKNOWLEDGED);
            }
            assertTrue(said - acknowledged < 0x8000, said + " said, " + acknowledged + " acknowledged");
        }
        assertEquals(1 + frames * 175, said);
    }

    /** The packets of one protocol: 6 TCP, 17 UDP. */
    private static List<ByteBuffer> packets(Path file, int protocol) throws IOException {
        return packets(file).stream()
                .filter(packet -> packet.get(9) == protocol)
                .toList();
    }

    private static String text(ByteBuffer segment) {
        return new String(data(segment, 20), StandardCharsets.US_ASCII);
    }

    @Test
    void speechIsADatagramOnPortsThatMgcpHasAnnounced() throws IOException {
        Path file = folder.resolve("a.pcap");
        byte[] rtp = new byte[172];
        rtp[0] = (byte) 0x80;
        try (Capture capture = Capture.start(CapturePlan.of(file, 1))) {
            WireTap tap = conversation(capture);
            tap.received(new IpaFrame(IpaFrame.SPEECH, rtp));
            tap.sent(IpaFramer.encode(new IpaFrame(IpaFrame.SPEECH, rtp)));
            tap.closed(true);
        }
        List<ByteBuffer> speech = packets(file, 17);
        assertEquals(2, speech.size());
        int terminal = speech.get(0).getShort(20) & 0xffff;
        int center = speech.get(0).getShort(22) & 0xffff;
        assertEquals(center, speech.get(1).getShort(20) & 0xffff);
        assertEquals(terminal, speech.get(1).getShort(22) & 0xffff);
        assertEquals(20 + 8 + 172, speech.get(0).capacity());

        List<ByteBuffer> signalling = packets(file, 6);
        assertTrue(text(signalling.get(3)).contains("CRCX 1 "), text(signalling.get(3)));
        assertTrue(text(signalling.get(3)).contains("m=audio " + center + " RTP/AVP 8 3"));
        assertTrue(text(signalling.get(4)).contains("m=audio " + terminal + " RTP/AVP 8 3"));
        assertTrue(text(signalling.get(5)).contains("DLCX 2 "), text(signalling.get(5)));
        assertEquals(0xfc, data(signalling.get(3), 20)[2] & 0xff, "the stream of MGCP");
    }

    @Test
    void afterASilenceTheNextSpeechHasPortsOfItsOwn() throws IOException {
        Path file = folder.resolve("a.pcap");
        InetSocketAddress peer = address("127.0.0.2", 40_000);
        InetSocketAddress center = address("127.0.0.1", 5_000);
        try (Capture capture = Capture.start(CapturePlan.of(file, 1))) {
            TcpConversation tcp = new TcpConversation(capture, peer, center);
            SpeechConversation speech = new SpeechConversation(
                    capture, tcp, IpHeader.between(peer.getAddress(), center.getAddress()), peer, center);
            long millis = 1_000_000;
            speech.speech(true, new byte[45], 0);
            speech.speech(true, new byte[45], 400 * millis);
            speech.speech(true, new byte[45], 801 * millis);
        }
        List<Integer> ports = packets(file, 17).stream()
                .map(packet -> packet.getShort(22) & 0xffff)
                .toList();
        assertEquals(ports.get(0), ports.get(1));
        assertEquals(ports.get(0) + 4, ports.get(2));
    }

    @Test
    void anIpv6PeerTalksIpv6() throws IOException {
        Path file = folder.resolve("a.pcap");
        try (Capture capture = Capture.start(CapturePlan.of(file, 1))) {
            capture.conversation(address("::1", 40_000), address("::1", 3003)).sent(new byte[] {7});
        }
        ByteBuffer packet = packets(file).get(3);
        assertEquals(6, packet.get(0) >> 4);
        assertEquals(TCP_HEADER + 1, packet.getShort(4));
        assertArrayEquals(new byte[] {7}, data(packet, 40));
    }

    @Test
    void aFullFileIsPutAsideAndTheNewestStays() throws IOException {
        Path file = folder.resolve("a.pcap");
        CapturePlan plan = new CapturePlan(file, 4_096);
        assertEquals(folder.resolve("a.1.pcap"), plan.previous());
        PcapFile first = PcapFile.create(file);
        PacketBuffer packets = new PacketBuffer(4_096);
        assertTrue(packets.add(1, 2, new byte[] {1}));
        first.write(packets);
        PcapFile second = first.startAnew(plan.previous());
        packets.clear();
        assertTrue(packets.add(3, 4, new byte[] {2}));
        second.write(packets);
        second.close();
        assertEquals(1, packets(plan.previous()).get(0).get(0));
        assertEquals(2, packets(file).get(0).get(0));
        assertEquals(FILE_HEADER + 16 + 1, Files.size(file));
    }

    @Test
    void aBufferTakesWhatItHasRoomForAndNoMore() {
        PacketBuffer packets = new PacketBuffer(200_000);
        int taken = 0;
        while (packets.add(0, 0, new byte[1_000])) {
            taken++;
        }
        assertEquals(200_000 / 1_016, taken);
        assertFalse(packets.isEmpty());
        packets.clear();
        assertTrue(packets.isEmpty());
    }

    @Test
    void aFileThatCannotBeWrittenIsNamed() {
        Path file = folder.resolve("missing").resolve("a.pcap");
        String text = assertThrows(IOException.class, () -> Capture.start(CapturePlan.of(file, 1)))
                .getMessage();
        assertEquals("cannot capture to " + file + ": no such folder", text);
    }
}
