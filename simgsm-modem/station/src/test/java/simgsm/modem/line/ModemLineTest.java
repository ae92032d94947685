package simgsm.modem.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import simgsm.modem.client.ModemCheck;
import simgsm.net.LineAddress;

class ModemLineTest implements ModemLine.Party {
    private static final int PATIENCE_SECONDS = 30;
    private final BlockingQueue<String> told = new LinkedBlockingQueue<>();
    private final AtomicReference<Throwable> failure = new AtomicReference<>();

    @Override
    public void lineUp(long nowNanos) {
        told.add("up");
    }

    @Override
    public void lineDown(long nowNanos) {
        told.add("down");
    }

    @Override
    public void received(byte[] octets, long nowNanos) {
        told.add(new String(octets, StandardCharsets.ISO_8859_1));
    }

    @Override
    public void timePassed(long nowNanos) {
        assertTrue(nowNanos >= 0);
    }

    @Override
    public long nextDeadlineNanos() {
        return ModemLine.NO_DEADLINE;
    }

    @Override
    public void lineFailed(String reason) {
        told.add("failed");
    }

    @Override
    public void closing() {
        told.add("closing");
    }

    private String next() throws InterruptedException {
        return told.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
    }

    private ModemLine line(int port) {
        ModemLine line = new ModemLine("test", LineAddress.parse("127.0.0.1:" + port), failure::set);
        line.attach(this);
        line.start();
        return line;
    }

    @Test
    void octetsGoBothWaysAndALostLineIsOpenedAgain() throws Exception {
        try (ServerSocket modem = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
                ModemLine line = line(modem.getLocalPort())) {
            try (Socket client = modem.accept()) {
                assertEquals("up", next());
                line.send("AT\r");
                InputStream in = client.getInputStream();
                assertEquals("AT\r", new String(in.readNBytes(3), StandardCharsets.ISO_8859_1));
                client.getOutputStream().write("OK\r\n".getBytes(StandardCharsets.ISO_8859_1));
                assertEquals("OK\r\n", next());
            }
            assertEquals("down", next());
            try (Socket again = modem.accept()) {
                assertTrue(again.isConnected());
                assertEquals("up", next());
                CompletableFuture<String> ran = new CompletableFuture<>();
                line.execute(() -> ran.complete(Thread.currentThread().getName()));
                assertEquals("test", ran.get(PATIENCE_SECONDS, TimeUnit.SECONDS));
                line.end();
                assertEquals("closing", next());
                assertEquals(-1, again.getInputStream().read());
            }
        }
        assertNull(failure.get());
    }

    @Test
    void aLineThatCannotBeOpenedSaysSo() throws Exception {
        int port;
        try (ServerSocket closed = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = closed.getLocalPort();
        }
        try (ModemLine line = line(port)) {
            assertEquals("failed", next());
            assertEquals("down", next());
            line.send("AT\r");
        }
        assertNull(failure.get());
    }

    @Test
    void aCheckReportsEachCommandAndWhetherTheModemCanServe() {
        StringBuilder sent = new StringBuilder();
        List<String> results = new ArrayList<>();
        List<Boolean> done = new ArrayList<>();
        ModemCheck check = new ModemCheck(
                sent::append,
                result -> results.add(result.command() + " " + result.verdict().word()),
                done::add);
        check.lineUp(0);
        long now = 0;
        while (done.isEmpty()) {
            now += 10_000_000;
            check.timePassed(now);
            String command = sent.toString();
            sent.setLength(0);
            if (command.endsWith("\r")) {
                String answer = command.contains("CREG?") ? "+CREG: 1,2\r\nOK\r\n" : "OK\r\n";
                check.received(answer.getBytes(StandardCharsets.ISO_8859_1), now);
            }
        }
        assertEquals(List.of(false), done);
        assertEquals("AT ok", results.get(0));
        assertEquals("AT+CREG? unexpected", results.get(results.size() - 1));
        assertTrue(results.contains("AT+CPIN? unexpected"));
        check.lineDown(now);
        check.lineFailed("gone");
        assertEquals(1, done.size(), "a check ends once");
        assertFalse(check.nextDeadlineNanos() < 0);
    }

    @Test
    void aCheckOfASilentModemEnds() {
        List<String> results = new ArrayList<>();
        List<Boolean> done = new ArrayList<>();
        ModemCheck check = new ModemCheck(
                octets -> {}, result -> results.add(result.command() + " " + result.answer()), done::add);
        check.lineUp(0);
        check.timePassed(10_000_000_000L);
        assertEquals(List.of("AT no answer"), results);
        assertEquals(List.of(false), done);
    }
}
