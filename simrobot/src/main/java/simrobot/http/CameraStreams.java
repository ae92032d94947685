package simrobot.http;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Semaphore;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.web.RequestException;
import simgsm.web.WebResponse;
import simrobot.camera.CameraPictureCache;

/** The camera streams of all clients, at most 16, each on its own thread, so that a slow client does not delay others. */
final class CameraStreams implements AutoCloseable {
    static final int MOST = 16;

    /** Default of {@code ?fps=N}. */
    private static final double USUAL_RATE = 10;

    private static final int MOST_RATE = 20;
    private static final Pattern RATE = Pattern.compile("(?:.*&)?fps=([^&]*)(?:&.*)?");

    private final SceneCache scenes;
    private final CameraPictureCache cameras;
    private final Semaphore places = new Semaphore(MOST);
    private final Set<CameraStream> running = ConcurrentHashMap.newKeySet();

    CameraStreams(SceneCache scenes, CameraPictureCache cameras) {
        this.scenes = scenes;
        this.cameras = cameras;
    }

    /** Answers GET with a stream, HEAD with the headers only. */
    void begin(HttpExchange exchange, String robot) throws IOException, RequestException {
        double rate = rate(exchange.getRequestURI().getRawQuery());
        boolean headersOnly = exchange.getRequestMethod().equals("HEAD");
        if (!headersOnly && !places.tryAcquire()) {
            exchange.getResponseHeaders().set("Retry-After", "5");
            throw new RequestException(WebResponse.UNAVAILABLE, "all " + MOST + " streams are taken, expected later");
        }
        Headers headers = exchange.getResponseHeaders();
        headers.set("Content-Type", "multipart/x-mixed-replace; boundary=" + CameraStream.BOUNDARY);
        headers.set("Cache-Control", "no-store");
        headers.set("X-Content-Type-Options", "nosniff");
        if (headersOnly) {
            exchange.sendResponseHeaders(WebResponse.OK, -1);
            exchange.close();
        } else {
            watch(exchange, robot, rate);
        }
    }

    private void watch(HttpExchange exchange, String robot, double rate) throws IOException {
        try {
            sendHeaders(exchange);
        } catch (IOException | RuntimeException failure) {
            places.release();
            throw failure;
        }
        CameraStream stream = new CameraStream(exchange, robot, rate, scenes, cameras);
        running.add(stream);
        stream.start(() -> {
            running.remove(stream);
            places.release();
        });
    }

    /** The length is unknown, so the connection ends with the stream. */
    private static void sendHeaders(HttpExchange exchange) throws IOException {
        exchange.getResponseHeaders().set("Connection", "close");
        exchange.sendResponseHeaders(WebResponse.OK, 0);
    }

    private static double rate(String query) throws RequestException {
        Optional<String> wanted = Optional.ofNullable(query)
                .map(RATE::matcher)
                .filter(Matcher::matches)
                .map(m -> m.group(1));
        if (wanted.isEmpty()) {
            return USUAL_RATE;
        }
        String text = wanted.get();
        if (text.matches("[0-9]{1,2}") && Integer.parseInt(text) >= 1 && Integer.parseInt(text) <= MOST_RATE) {
            return Integer.parseInt(text);
        }
        throw new RequestException(
                WebResponse.BAD_REQUEST, "fps: expected a whole number of 1 to " + MOST_RATE + ", found " + text);
    }

    @Override
    public void close() {
        running.forEach(CameraStream::close);
    }
}
