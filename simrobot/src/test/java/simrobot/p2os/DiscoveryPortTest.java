package simrobot.p2os;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class DiscoveryPortTest {
    private static final InetAddress HERE = InetAddress.getLoopbackAddress();

    @Test
    void aSearchIsAnsweredAndAnythingElseIsNot() throws IOException {
        try (DiscoveryPort port = DiscoveryPort.open(new InetSocketAddress(HERE, 0));
                DatagramSocket client = new DatagramSocket(0, HERE)) {
            port.start();
            for (byte[] request : new byte[][] {{}, {0, 0, (byte) 0xF6}, {0, 0, 0, 1}, {0, 0, 0, (byte) 0xF6}}) {
                client.send(new DatagramPacket(request, request.length, HERE, port.port()));
            }
            DatagramPacket answer = new DatagramPacket(new byte[100], 100);
            client.setSoTimeout(10_000);
            client.receive(answer);
            byte[] expected = new byte[30];
            expected[3] = (byte) 0xF7;
            expected[8] = (byte) 0xFA;
            expected[9] = (byte) 0xFB;
            assertEquals(30, answer.getLength());
            assertArrayEquals(expected, Arrays.copyOf(answer.getData(), 30));
            client.send(new DatagramPacket(new byte[] {9, 9, 9, (byte) 0xF6, 7}, 5, HERE, port.port()));
            client.receive(answer);
            assertEquals(30, answer.getLength(), "only the fourth octet counts");
        }
    }

    @Test
    void aPortInUseIsRefused() throws IOException {
        try (DiscoveryPort port = DiscoveryPort.open(new InetSocketAddress(HERE, 0))) {
            InetSocketAddress taken = new InetSocketAddress(HERE, port.port());
            assertThrows(IOException.class, () -> DiscoveryPort.open(taken));
        }
    }
}
