package simgsm.center.net;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simgsm.abis.CcmMessage;
import simgsm.abis.IpaFrame;
import simgsm.air.MobilityManagement;
import simgsm.air.Msisdn;
import simgsm.center.msc.Exchange;
import simgsm.center.msc.ExchangeEvent;
import simgsm.center.msc.ExchangeSettings;
import simgsm.center.msc.link.LinkPort;
import simgsm.center.msc.link.Peer;
import simgsm.center.smsc.MessageStore;

/** What real sockets do to frames: split them, join them, break off in the middle, and send nonsense. */
@Timeout(60)
class CenterLoopTest {
    private static final ExchangeEvent ATTACHED = new ExchangeEvent.Attached(new Msisdn("5550100"));
    private static final ExchangeEvent DETACHED = new ExchangeEvent.Detached(new Msisdn("5550100"));

    private final BlockingQueue<ExchangeEvent> events = new LinkedBlockingQueue<>();
    private CenterLoop loop;
    private final CompletableFuture<Throwable> failure = new CompletableFuture<>();

    @BeforeEach
    void open() throws IOException {
        loop = CenterLoop.open(InetAddress.getLoopbackAddress(), 0, PortLimits.STANDARD);
        MessageStore store =
                (ticket, entries) -> loop.post(exchange -> exchange.committed(loop.nowNanos(), ticket, true));
        loop.start(
                new Exchange(new ExchangeSettings("SimGSM", 1, Instant.EPOCH), store, events::add),
                cause -> failure.complete(cause));
    }

    @AfterEach
    void close() {
        loop.close();
    }

    private ExchangeEvent nextEvent() throws InterruptedException {
        return events.poll(20, TimeUnit.SECONDS);
    }

    private <T> T ask(Function<Exchange, T> question) {
        CompletableFuture<T> answer = new CompletableFuture<>();
        loop.post(exchange -> answer.complete(question.apply(exchange)));
        return answer.join();
    }

    /** The centre still serves new connections. */
    private void assertServes() throws Exception {
        try (TestClient client = new TestClient(loop.port())) {
            client.register("5559999");
        }
    }

    @Test
    void aTerminalIsGreetedAndRegisters() throws Exception {
        try (TestClient client = new TestClient(loop.port())) {
            assertEquals(IpaFrame.CCM, client.read().stream());
            client.register("5550100");
            assertEquals(ATTACHED, nextEvent());
        }
        assertEquals(DETACHED, nextEvent());
    }

    @Test
    void framesMayComeByteByByte() throws Exception {
        try (TestClient client = new TestClient(loop.port())) {
            client.writeByteByByte(TestClient.updateRequest("5550100"));
            client.await(MobilityManagement.IdentityRequest.class);
            client.writeByteByByte(TestClient.identity());
            client.await(MobilityManagement.LocationUpdatingAccept.class);
        }
    }

    @Test
    void manyFramesMayComeInOneSegment() throws Exception {
        try (TestClient client = new TestClient(loop.port())) {
            ByteArrayOutputStream all = new ByteArrayOutputStream();
            for (int i = 0; i < 200; i++) {
                all.writeBytes(TestClient.frame(new CcmMessage.Ping()));
            }
            all.writeBytes(TestClient.updateRequest("5550100"));
            all.writeBytes(TestClient.identity());
            client.write(all.toByteArray());
            client.await(MobilityManagement.LocationUpdatingAccept.class);
        }
    }

    @Test
    void aFrameThatIsTooLongEndsItsConnectionAndNoOther() throws Exception {
        try (TestClient good = new TestClient(loop.port());
                TestClient bad = new TestClient(loop.port())) {
            good.register("5550100");
            bad.write(new byte[] {(byte) 0xff, (byte) 0xff, 0});
            bad.awaitEnd();
            good.write(TestClient.updateRequest("5550100"));
            good.await(MobilityManagement.IdentityRequest.class);
        }
        assertServes();
    }

    @Test
    void aBrowserThatLosesItsWayIsShownTheDoor() throws Exception {
        try (TestClient client = new TestClient(loop.port())) {
            client.write("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n".getBytes(StandardCharsets.US_ASCII));
            client.awaitEnd();
        }
        assertServes();
    }

    @Test
    void garbageOfEveryKindIsSurvived() throws Exception {
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 50; i++) {
            try (TestClient client = new TestClient(loop.port())) {
                byte[] garbage = new byte[1 + random.nextInt(3_000)];
                random.nextBytes(garbage);
                // Half of them with lengths that are believable.
                if (i % 2 == 0) {
                    for (int at = 0; at + 20 < garbage.length; at += 20) {
                        garbage[at] = 0;
                        garbage[at + 1] = 17;
                        garbage[at + 2] = (byte) (at % 3 == 0 ? IpaFrame.RSL : IpaFrame.CCM);
                    }
                }
                client.write(garbage);
            } catch (IOException e) {
                // It was shown the door while it still wrote.
            }
        }
        assertServes();
    }

    @Test
    void aConnectionThatEndsInTheMiddleOfAFrameLeavesNothingBehind() throws Exception {
        byte[] whole = TestClient.updateRequest("5550100");
        for (int length = 0; length <= whole.length; length++) {
            try (TestClient client = new TestClient(loop.port())) {
                client.write(java.util.Arrays.copyOf(whole, length));
            }
        }
        try (TestClient client = new TestClient(loop.port())) {
            client.register("5550100");
            assertEquals(ATTACHED, nextEvent());
        }
        assertEquals(DETACHED, nextEvent());
        // Closings are heard in no particular order, so ask until the last one has been.
        while (ask(Exchange::linkCount) > 0) {
            Thread.onSpinWait();
        }
    }

    @Test
    void closingTheLoopEndsEveryConnection() throws Exception {
        try (TestClient client = new TestClient(loop.port())) {
            client.register("5550100");
            loop.close();
            client.awaitEnd();
        }
        loop.close();
        assertFalse(failure.isDone(), "it was told to");
    }

    @Test
    void aPortThatIsTakenIsNamed() {
        int port = loop.port();
        IOException failure = assertThrows(
                IOException.class, () -> CenterLoop.open(InetAddress.getLoopbackAddress(), port, PortLimits.STANDARD));
        assertTrue(failure.getMessage().contains("port " + port), failure.getMessage());
    }

    @Test
    void aTaskThatFailsDoesNotEndTheLoop() throws Exception {
        loop.post(exchange -> {
            throw new IllegalStateException("on purpose");
        });
        assertServes();
    }

    /** A terminal of the exchange whose line works until the first answer to a request of the terminal. */
    private static final class FaultyLine implements LinkPort {
        @Override
        public void send(IpaFrame frame) {
            if (frame.stream() == IpaFrame.RSL) {
                throw new IllegalStateException("on purpose");
            }
        }

        @Override
        public void close(String reason) {}
    }

    @Test
    void anErrorOfOurOwnWhileATerminalIsWelcomedCostsThatTerminalAlone() throws Exception {
        CountDownLatch isUndone = new CountDownLatch(1);
        CountDownLatch isAtTheDoor = new CountDownLatch(1);
        loop.post(exchange -> {
            Peer link = exchange.linkOpened(loop.nowNanos(), new FaultyLine(), "faulty");
            assertThrows(
                    IllegalStateException.class,
                    () -> exchange.frameReceived(loop.nowNanos(), link, TestClient.serviceRequest()));
            // What is left undone meets the next who comes.
            isUndone.countDown();
            await(isAtTheDoor);
        });
        await(isUndone);
        try (TestClient client = new TestClient(loop.port())) {
            isAtTheDoor.countDown();
            client.awaitEnd();
        }
        assertServes();
        assertFalse(failure.isDone());
    }

    /** It is read no faster than it may send, in portions; the other connections are served in between. */
    @Test
    void aFloodDelaysNoOtherConnectionAndIsAnsweredInFull() throws Exception {
        try (TestClient flooder = new TestClient(loop.port());
                TestClient good = new TestClient(loop.port())) {
            int flood = 3 * TerminalConnection.LOCAL_BURST_FRAMES / 2;
            byte[] ping = TestClient.frame(new CcmMessage.Ping());
            byte[] all = new byte[flood * ping.length];
            for (int i = 0; i < flood; i++) {
                System.arraycopy(ping, 0, all, i * ping.length, ping.length);
            }
            flooder.write(TestClient.frame(new CcmMessage.IdentityResponse("flooder", "001017500000017")));
            Thread writer = new Thread(() -> {
                try {
                    flooder.write(all);
                } catch (IOException e) {
                    failure.complete(e);
                }
            });
            writer.start();
            readPongs(flooder, 1_000);
            good.register("5550100");
            assertEquals(ATTACHED, nextEvent());
            readPongs(flooder, flood - 1_000);
            writer.join();
            assertFalse(failure.isDone());
        }
    }

    private static void readPongs(TestClient client, int count) throws IOException {
        for (int left = count; left > 0; ) {
            IpaFrame frame = client.read();
            if (frame.stream() == IpaFrame.CCM && frame.payload()[0] == 1) {
                left--;
            }
        }
    }

    @Test
    void silentPeersDelayNoOtherConnection() throws Exception {
        List<TestClient> silent = new ArrayList<>();
        try {
            for (int i = 0; i < 200; i++) {
                silent.add(new TestClient(loop.port()));
                silent.get(i).write(new byte[] {0, 17});
            }
            assertServes();
        } finally {
            for (TestClient each : silent) {
                each.close();
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

    @Test
    void anErrorOfTheVirtualMachineEndsTheLoopAndIsReported() throws Exception {
        loop.post(exchange -> {
            throw new LinkageError("on purpose");
        });
        assertEquals("on purpose", failure.get(20, TimeUnit.SECONDS).getMessage());
    }
}
