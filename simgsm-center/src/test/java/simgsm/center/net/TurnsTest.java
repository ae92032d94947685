package simgsm.center.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.channels.SocketChannel;
import org.junit.jupiter.api.Test;
import simgsm.center.capture.WireTap;

class TurnsTest {
    private static Connection connection() throws IOException {
        try (SocketChannel channel = SocketChannel.open()) {
            InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), 1);
            return new Connection(new Peer.Incoming(channel, null, address), null, WireTap.NONE);
        }
    }

    @Test
    void thoseWhoWaitGoOnInTheirOrderAndTheTooFastOnesLater() throws IOException {
        FairReadQueue turns = new FairReadQueue();
        Connection fast = connection();
        Connection first = connection();
        Connection second = connection();
        assertEquals(Long.MAX_VALUE, turns.dueNanos());
        turns.add(fast, RateLimitedFrameReader.Rest.FOR_LATER, 100);
        turns.add(first, RateLimitedFrameReader.Rest.FOR_ANOTHER_TURN, 100);
        turns.add(second, RateLimitedFrameReader.Rest.FOR_ANOTHER_TURN, 100);
        assertEquals(100, turns.dueNanos());
        assertSame(first, turns.next(100));
        assertSame(second, turns.next(100));
        assertNull(turns.next(100));
        assertEquals(100 + FairReadQueue.REST_NANOS, turns.dueNanos());
        assertSame(fast, turns.next(100 + FairReadQueue.REST_NANOS));
    }
}
