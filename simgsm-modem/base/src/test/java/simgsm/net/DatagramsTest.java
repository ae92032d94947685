package simgsm.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class DatagramsTest {
    private static final int PATIENCE_MILLIS = 30_000;

    private final InetAddress here = InetAddress.getLoopbackAddress();
    private final SelectorLoop loop = new SelectorLoop("datagrams");
    private final LinkedBlockingQueue<byte[]> received = new LinkedBlockingQueue<>();
    private Datagrams socket;

    @BeforeEach
    void open() {
        loop.start(SelectorLoop.Core.NONE, fault -> {});
        socket = loop.ask(() -> Datagrams.open(loop, here, received::add));
    }

    @AfterEach
    void close() {
        loop.close();
    }

    private void send(DatagramSocket from, int octet) throws Exception {
        from.send(new DatagramPacket(new byte[] {(byte) octet}, 1, socket.localAddress()));
    }

    @Test
    void thePortIsEvenAsRtpHasIt() {
        assertEquals(0, socket.localAddress().getPort() % 2);
    }

    @Test
    void withoutAPeerNothingIsSentAndNothingTaken() throws Exception {
        assertFalse(loop.ask(() -> socket.send(new byte[1])));
        try (DatagramSocket early = new DatagramSocket(0, here);
                DatagramSocket peer = new DatagramSocket(0, here)) {
            send(early, 1);
            connect(peer);
            send(peer, 2);
            byte[] first = received.poll(PATIENCE_MILLIS, TimeUnit.MILLISECONDS);
            assertArrayEquals(new byte[] {2}, first);
        }
    }

    @Test
    void onlyThePeerIsHeard() throws Exception {
        try (DatagramSocket peer = new DatagramSocket(0, here);
                DatagramSocket stranger = new DatagramSocket(0, here)) {
            connect(peer);
            send(stranger, 1);
            send(peer, 2);
            assertArrayEquals(new byte[] {2}, received.poll(PATIENCE_MILLIS, TimeUnit.MILLISECONDS));
            assertTrue(received.isEmpty());
        }
    }

    @Test
    void whatIsSentArrivesAtThePeer() throws Exception {
        try (DatagramSocket peer = new DatagramSocket(0, here)) {
            connect(peer);
            assertTrue(loop.ask(() -> socket.send(new byte[] {1, 2, 3})));
            peer.setSoTimeout(PATIENCE_MILLIS);
            DatagramPacket packet = new DatagramPacket(new byte[16], 16);
            peer.receive(packet);
            assertEquals(3, packet.getLength());
            assertEquals(socket.localAddress(), packet.getSocketAddress());
        }
    }

    private void connect(DatagramSocket peer) {
        loop.ask(() -> {
            socket.connect(new InetSocketAddress(here, peer.getLocalPort()));
            return null;
        });
    }

    @Test
    void aSocketForManyPeersHearsAndAnswersEach() throws Exception {
        LinkedBlockingQueue<InetSocketAddress> sources = new LinkedBlockingQueue<>();
        socket = loop.ask(() -> Datagrams.open(loop, new InetSocketAddress(here, 0), (octets, from) -> {
            received.add(octets);
            sources.add(from);
        }));
        try (DatagramSocket one = new DatagramSocket(0, here);
                DatagramSocket other = new DatagramSocket(0, here)) {
            for (DatagramSocket peer : new DatagramSocket[] {one, other}) {
                send(peer, 7);
                assertArrayEquals(new byte[] {7}, received.poll(PATIENCE_MILLIS, TimeUnit.MILLISECONDS));
                InetSocketAddress source = sources.poll(PATIENCE_MILLIS, TimeUnit.MILLISECONDS);
                assertEquals(peer.getLocalPort(), source.getPort());
                loop.ask(() -> {
                    socket.send(new byte[] {8, 9}, source);
                    return true;
                });
                peer.setSoTimeout(PATIENCE_MILLIS);
                DatagramPacket packet = new DatagramPacket(new byte[16], 16);
                peer.receive(packet);
                assertEquals(2, packet.getLength());
            }
        }
    }

    @Test
    void aTakenPortIsRefusedByAddressAndNumber() {
        InetSocketAddress taken = socket.localAddress();

        IOException refusal = assertThrows(IOException.class, () -> Datagrams.open(loop, taken, (octets, from) -> {}));

        assertTrue(refusal.getMessage().contains("UDP port " + taken.getPort()), refusal.getMessage());
    }
}
