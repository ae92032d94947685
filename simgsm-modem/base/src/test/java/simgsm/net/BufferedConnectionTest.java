package simgsm.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Connections with a buffer of output, over real sockets. */
@Timeout(60)
class BufferedConnectionTest {
    private static final int ENOUGH = 100_000;
    private static final int TOO_MUCH = 16 * 1024 * 1024;

    private final BlockingQueue<String> events = new LinkedBlockingQueue<>();
    private final SelectorLoop loop = new SelectorLoop("loop", Duration.ofSeconds(50));
    private Socket socket;

    /** Answers an octet n by the octets 1 to n; 0 by an end; 'b' by 1 MiB, again and again. */
    private final class Answers extends BufferedConnection {
        Answers(Endpoint endpoint) {
            super(endpoint, ENOUGH, TOO_MUCH);
        }

        @Override
        protected void received(ByteBuffer octets) {
            int count = octets.get();
            if (count == 'b') {
                while (isOpen()) {
                    send(new byte[1024 * 1024]);
                }
                return;
            }
            for (int i = 1; i <= count; i++) {
                send(new byte[] {(byte) i});
            }
            closeWhenSent();
            events.add("ending " + isEnding());
        }

        @Override
        protected void lost(String reason) {
            events.add("lost " + reason);
        }
    }

    @BeforeEach
    void connect() throws IOException {
        InetSocketAddress any = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
        int port = loop.listen(any, new ConnectionLimits(10, 10), Answers::new).port();
        loop.start(SelectorLoop.Core.NONE, fault -> events.add("failed " + fault.getMessage()));
        socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(20_000);
    }

    @AfterEach
    void close() throws IOException {
        socket.close();
        loop.close();
    }

    private void expect(String event) throws InterruptedException {
        assertEquals(event, events.poll(20, TimeUnit.SECONDS));
    }

    @Test
    void theConnectionEndsAfterItsLastOctet() throws Exception {
        socket.getOutputStream().write(3);
        assertArrayEquals(new byte[] {1, 2, 3}, socket.getInputStream().readAllBytes());
        expect("ending true");
        expect("lost ended");
    }

    @Test
    void aConnectionWithoutOutputEndsAtOnce() throws Exception {
        socket.getOutputStream().write(0);
        assertEquals(-1, socket.getInputStream().read());
        expect("ending true");
        expect("lost ended");
    }

    @Test
    void aPeerThatReadsTooLittleIsDisconnected() throws Exception {
        socket.getOutputStream().write('b');
        expect("lost " + 17 * 1024 * 1024 + " octets not taken");
    }
}
