package blackbox;

import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import simgsm.web.JsonReader;

/** A client's side of a WebSocket that sends and receives JSON objects. */
class JsonSocket implements AutoCloseable, WebSocket.Listener {
    private static final HttpClient CLIENT = HttpClient.newHttpClient();

    private final BlockingQueue<Map<String, Object>> received = new LinkedBlockingQueue<>();
    private final CompletableFuture<Integer> closed = new CompletableFuture<>();
    private final StringBuilder text = new StringBuilder();
    private final WebSocket socket;

    /** @param headers of the handshake */
    JsonSocket(String port, String path, UnaryOperator<WebSocket.Builder> headers) {
        socket = headers.apply(CLIENT.newWebSocketBuilder())
                .buildAsync(URI.create("ws://127.0.0.1:" + port + path), this)
                .join();
    }

    /** Sends a text; a text and the sound of another thread wait for one another, as the socket refuses a second message. */
    public final synchronized void say(String message) {
        socket.sendText(message, true).join();
    }

    final synchronized void sendOctets(byte[] octets) {
        socket.sendBinary(ByteBuffer.wrap(octets), true).join();
    }

    /** Waits for such a message, and skips others. */
    final Map<String, Object> expect(Predicate<Map<String, Object>> wanted, String what) {
        try {
            Map<String, Object> message;
            do {
                message = received.poll(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS);
                assertNotNull(message, "no " + what);
            } while (!wanted.test(message));
            return message;
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    final int closeCode() throws Exception {
        return closed.get(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS);
    }

    @Override
    public final CompletionStage<?> onText(WebSocket from, CharSequence part, boolean last) {
        text.append(part);
        if (last) {
            received.add(JsonReader.object(text.toString()));
            text.setLength(0);
        }
        from.request(1);
        return null;
    }

    @Override
    public final CompletionStage<?> onClose(WebSocket from, int code, String reason) {
        closed.complete(code);
        return null;
    }

    @Override
    public final void onError(WebSocket from, Throwable fault) {
        closed.completeExceptionally(fault);
    }

    /** Cuts the connection, as when a client loses its network. */
    void cut() {
        socket.abort();
    }

    @Override
    public void close() {
        cut();
    }
}
