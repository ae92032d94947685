package simgsm.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The loop with real sockets; its work is counted per iteration, never timed. */
@Timeout(60)
class SelectorLoopTest {
    private static final InetSocketAddress ANY_PORT = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);

    private final BlockingQueue<String> events = new LinkedBlockingQueue<>();
    private final SelectorLoop loop = new SelectorLoop("loop", Duration.ofSeconds(50));

    @AfterEach
    void close() {
        loop.close();
    }

    private void start() {
        loop.start(SelectorLoop.Core.NONE, fault -> events.add("failed " + fault.getMessage()));
    }

    private void expect(String event) throws InterruptedException {
        assertEquals(event, events.poll(20, TimeUnit.SECONDS));
    }

    /** Sends back what it receives, a bounded number of octets per iteration; 'x' makes it fail by an exception. */
    private final class Echo extends Connection {
        private final int limit;
        private ByteBuffer output = ByteBuffer.allocate(0);

        Echo(Endpoint endpoint, int limit) {
            super(endpoint);
            this.limit = limit;
        }

        @Override
        protected int readLimit() {
            return limit;
        }

        @Override
        protected void received(ByteBuffer octets) {
            served++;
            mostServed = Math.max(mostServed, octets.remaining());
            output = ByteBuffer.allocate(octets.remaining()).put(octets).flip();
            if (output.get(0) == 'x') {
                throw new IllegalStateException("on purpose");
            }
            flushLater();
        }

        @Override
        protected boolean hasOutput() {
            return output.hasRemaining();
        }

        @Override
        protected boolean wantsInput() {
            return !hasOutput();
        }

        @Override
        protected void writeTo(WritableByteChannel channel) throws IOException {
            channel.write(output);
        }

        @Override
        protected void lost(String reason) {
            events.add("lost " + reason);
        }
    }

    private int served;
    private int mostServed;

    private int listen(int limit, ConnectionLimits limits) throws IOException {
        return loop.listen(ANY_PORT, limits, endpoint -> new Echo(endpoint, limit))
                .port();
    }

    private static Socket connect(int port) throws IOException {
        Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
        socket.setSoTimeout(20_000);
        return socket;
    }

    private static int echo(Socket socket, int octet) throws IOException {
        socket.getOutputStream().write(octet);
        return socket.getInputStream().read();
    }

    /** Answers an octet with so many messages that may be dropped, of which 10 may wait, and tells its writes. */
    private final class Burst extends QueuedConnection {
        Burst(Endpoint endpoint) {
            super(endpoint, new OutputQueue(1, 10, message -> events.add("written " + message[0])));
        }

        @Override
        protected void received(ByteBuffer octets) {
            int count = octets.get();
            for (int i = 1; i <= count; i++) {
                write(new byte[] {(byte) i}, true);
            }
            events.add("received " + count);
        }
    }

    @Test
    void messagesOfOneActionThatMayBeDroppedLeaveAtItsEnd() throws Exception {
        int port =
                loop.listen(ANY_PORT, new ConnectionLimits(10, 10), Burst::new).port();
        start();
        try (Socket socket = connect(port)) {
            assertEquals(1, echo(socket, 2));
            assertEquals(2, socket.getInputStream().read());
            expect("received 2");
            expect("written 1");
            expect("written 2");
        }
    }

    @Test
    void ofABurstBeyondTheLimitNothingIsDroppedWhileThePeerTakesIt() throws Exception {
        int port =
                loop.listen(ANY_PORT, new ConnectionLimits(10, 10), Burst::new).port();
        start();
        try (Socket socket = connect(port)) {
            socket.getOutputStream().write(35);
            for (int i = 1; i <= 35; i++) {
                assertEquals(i, socket.getInputStream().read());
            }
        }
    }

    @Test
    void anExceptionEndsTheConnectionInWhichItOccurs() throws Exception {
        int port = listen(10, new ConnectionLimits(10, 10));
        start();
        try (Socket good = connect(port);
                Socket bad = connect(port)) {
            assertEquals('a', echo(good, 'a'));
            assertEquals(-1, echo(bad, 'x'));
            expect("lost internal error");
            assertEquals('b', echo(good, 'b'));
        }
    }

    @Test
    void connectionsBeyondTheLimitAreClosedAndOneThatEndsMakesRoom() throws Exception {
        int port = listen(10, new ConnectionLimits(1, 1));
        start();
        try (Socket first = connect(port)) {
            assertEquals('a', echo(first, 'a'));
            try (Socket second = connect(port)) {
                assertEquals(-1, second.getInputStream().read());
            }
        }
        expect("lost closed by the peer");
        try (Socket third = connect(port)) {
            assertEquals('c', echo(third, 'c'));
        }
    }

    /** 1 000 peers with 100 octets each: per iteration a peer is served once, with 10 octets at most. */
    @Test
    void oneIterationServesEachOfAThousandPeersAtMostOnceWithALimitedRead() throws Exception {
        int count = 1_000;
        int port = listen(10, new ConnectionLimits(count, count));
        start();
        List<Socket> peers = new ArrayList<>();
        try {
            for (int i = 0; i < count; i++) {
                peers.add(connect(port));
                assertEquals('a', echo(peers.get(i), 'a'));
            }
            List<Integer> servedPerIteration = new ArrayList<>();
            CountDownLatch isHeld = new CountDownLatch(1);
            CountDownLatch mayGoOn = new CountDownLatch(1);
            loop.post(() -> {
                isHeld.countDown();
                await(mayGoOn);
                countIterations(servedPerIteration, 10 * count);
            });
            isHeld.await();
            for (Socket peer : peers) {
                peer.getOutputStream().write(new byte[100]);
            }
            mayGoOn.countDown();
            for (Socket peer : peers) {
                assertEquals(100, peer.getInputStream().readNBytes(100).length);
            }
            expect("counted");
            assertTrue(servedPerIteration.stream().allMatch(each -> each <= count), servedPerIteration.toString());
            assertEquals(10, mostServed);
        } finally {
            for (Socket peer : peers) {
                peer.close();
            }
        }
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    /** A task that posts itself runs once per iteration. */
    private void countIterations(List<Integer> counts, int left) {
        int before = served;
        loop.post(() -> {
            counts.add(served - before);
            int rest = left - (served - before);
            if (rest > 0) {
                countIterations(counts, rest);
            } else {
                events.add("counted");
            }
        });
    }

    /** A flood of tasks that post further tasks does not keep the sockets waiting. */
    @Test
    void tasksPostedInAnIterationRunInTheNext() throws Exception {
        int port = listen(10, new ConnectionLimits(10, 10));
        start();
        loop.post(new Runnable() {
            @Override
            public void run() {
                loop.post(this);
            }
        });
        try (Socket peer = connect(port)) {
            assertEquals('a', echo(peer, 'a'));
        }
    }

    @Test
    void aTaskThatThrowsDoesNotEndTheLoop() {
        start();
        loop.post(() -> {
            throw new IllegalStateException("on purpose");
        });
        assertEquals("still there", loop.ask(() -> "still there"));
    }

    @Test
    void theExceptionOfAQuestionIsTheCallers() {
        start();
        assertThrows(
                UnsupportedOperationException.class,
                () -> loop.ask(() -> {
                    throw new UnsupportedOperationException("on purpose");
                }));
    }

    @Test
    void aQuestionToABusyLoopEndsAfterTheLimitAndIsNotAskedLater() throws Exception {
        SelectorLoop busy = new SelectorLoop("busy", Duration.ofMillis(200));
        busy.start(SelectorLoop.Core.NONE, fault -> {});
        CountDownLatch mayGoOn = new CountDownLatch(1);
        busy.post(() -> await(mayGoOn));
        IllegalStateException late =
                assertThrows(IllegalStateException.class, () -> busy.ask(() -> events.add("asked")));
        assertTrue(late.getMessage().contains("200 ms"), late.getMessage());
        mayGoOn.countDown();
        busy.post(() -> events.add("next"));
        expect("next");
        busy.close();
    }

    @Test
    void aTaskOrQuestionForAnEndedLoopFailsAtOnce() {
        start();
        loop.close();
        assertFalse(loop.post(() -> events.add("run")));
        IllegalStateException failure =
                assertThrows(IllegalStateException.class, () -> loop.ask(() -> events.add("asked")));
        assertTrue(failure.getMessage().contains("has ended"), failure.getMessage());
        assertTrue(events.isEmpty());
    }

    @Test
    void aQuestionThatWaitsWhenTheLoopEndsFailsThen() throws Exception {
        SelectorLoop slow = new SelectorLoop("slow", Duration.ofSeconds(50));
        slow.start(SelectorLoop.Core.NONE, fault -> {});
        slow.post(() -> {
            slow.end();
            slow.post(new java.util.concurrent.FutureTask<>(() -> events.add("asked")) {
                @Override
                protected void done() {
                    events.add(isCancelled() ? "cancelled" : "done");
                }
            });
        });
        expect("cancelled");
        slow.close();
    }

    @Test
    void anErrorEndsTheLoopAndIsReported() throws Exception {
        start();
        loop.post(() -> {
            throw new LinkageError("on purpose");
        });
        expect("failed on purpose");
        loop.close();
        assertFalse(loop.post(() -> {}));
    }

    @Test
    void anEndThatWasAskedForIsNoFailure() {
        start();
        loop.close();
        assertTrue(events.isEmpty());
    }

    @Test
    void aPortThatIsTakenIsNamed() throws IOException {
        int port = listen(10, new ConnectionLimits(10, 10));
        InetSocketAddress taken = new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
        IOException failure = assertThrows(
                IOException.class,
                () -> loop.listen(taken, new ConnectionLimits(1, 1), endpoint -> new Echo(endpoint, 1)));
        assertTrue(failure.getMessage().contains("port " + port), failure.getMessage());
    }

    /** 192.0.2.0/24 is kept for documents (RFC 5737); no machine has an address of it. */
    @Test
    void anAddressOfAnotherMachineIsNamedAsSuch() {
        IOException failure = assertThrows(
                IOException.class,
                () -> loop.listen(
                        new InetSocketAddress("192.0.2.1", 3003),
                        new ConnectionLimits(1, 1),
                        endpoint -> new Echo(endpoint, 1)));
        assertEquals("cannot listen on 192.0.2.1 port 3003: not an address of this machine", failure.getMessage());
    }
}
