package blackbox;

import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.io.ByteArrayOutputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import simgsm.dtmf.DtmfGenerator;
import simgsm.dtmf.DtmfKey;
import simgsm.speech.SpeechCodec;
import simgsm.web.JsonReader;

/** A page's side of the gateway's socket: JSON and A-law as the page sends them, in real time. */
final class WebPhone implements AutoCloseable, WebSocket.Listener {
    private final BlockingQueue<Map<String, Object>> events = new LinkedBlockingQueue<>();
    private final CompletableFuture<Integer> closed = new CompletableFuture<>();
    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor();
    private final DtmfGenerator keys = new DtmfGenerator();
    private final SpeechCodec codec = SpeechCodec.Kind.A_LAW.open();
    private final StringBuilder text = new StringBuilder();
    private final ByteArrayOutputStream heard = new ByteArrayOutputStream();
    private final WebSocket socket;

    /** Opens the socket and sends a first message. */
    WebPhone(String port, String first) {
        socket = HttpClient.newHttpClient()
                .newWebSocketBuilder()
                .subprotocols("simgsm.v1")
                .buildAsync(URI.create("ws://127.0.0.1:" + port + "/phone"), this)
                .join();
        say(first);
    }

    void say(String message) {
        socket.sendText(message, true).join();
    }

    void sendOctets(byte[] octets) {
        socket.sendBinary(ByteBuffer.wrap(octets), true).join();
    }

    /** Sends sound from now on, a frame every 20 ms. */
    void speak() {
        clock.scheduleAtFixedRate(this::sendFrame, 0, 20, TimeUnit.MILLISECONDS);
    }

    private void sendFrame() {
        short[] frame = new short[SpeechCodec.SAMPLES_PER_FRAME];
        synchronized (keys) {
            keys.read(frame);
        }
        sendOctets(codec.encode(frame));
    }

    void press(String pressed) {
        synchronized (keys) {
            DtmfKey.sequence(pressed).forEach(keys::enqueue);
        }
    }

    /** Waits for an event of this name, and skips others. */
    Map<String, Object> expect(String name) {
        return expect(event -> name.equals(event.get("event")), name);
    }

    /** Waits for an event with this value. */
    Map<String, Object> expect(String name, String field, String value) {
        return expect(
                event -> name.equals(event.get("event")) && value.equals(event.get(field)),
                name + " " + field + "=" + value);
    }

    private Map<String, Object> expect(Predicate<Map<String, Object>> wanted, String what) {
        try {
            Map<String, Object> event;
            do {
                event = events.poll(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS);
                assertNotNull(event, "no " + what);
            } while (!wanted.test(event));
            return event;
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    int closeCode() throws Exception {
        return closed.get(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS);
    }

    /** What has been heard so far. */
    short[] heard() {
        byte[] octets;
        synchronized (heard) {
            octets = heard.toByteArray();
        }
        short[] samples = new short[octets.length];
        for (int from = 0; from < octets.length; from += SpeechCodec.SAMPLES_PER_FRAME) {
            byte[] frame = new byte[SpeechCodec.SAMPLES_PER_FRAME];
            System.arraycopy(octets, from, frame, 0, frame.length);
            System.arraycopy(codec.decode(frame), 0, samples, from, frame.length);
        }
        return samples;
    }

    @Override
    public CompletionStage<?> onText(WebSocket from, CharSequence part, boolean last) {
        text.append(part);
        if (last) {
            events.add(JsonReader.object(text.toString()));
            text.setLength(0);
        }
        from.request(1);
        return null;
    }

    @Override
    public CompletionStage<?> onBinary(WebSocket from, ByteBuffer part, boolean last) {
        byte[] octets = new byte[part.remaining()];
        part.get(octets);
        synchronized (heard) {
            heard.writeBytes(octets);
        }
        from.request(1);
        return null;
    }

    @Override
    public CompletionStage<?> onClose(WebSocket from, int code, String reason) {
        closed.complete(code);
        return null;
    }

    @Override
    public void onError(WebSocket from, Throwable fault) {
        closed.completeExceptionally(fault);
    }

    /** The connection is cut, as when a browser loses its network. */
    void cut() {
        stopSpeaking();
        socket.abort();
    }

    private void stopSpeaking() {
        List<Runnable> unused = clock.shutdownNow();
        unused.clear();
    }

    @Override
    public void close() {
        cut();
    }
}
