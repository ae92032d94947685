package simrobot.http;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** All who watch cameras: at most so many, each on a thread of its own, so that nobody waits for a slow one. */
final class CameraStreams implements AutoCloseable {
    static final int MOST = 16;

    /** Pictures a second, unless {@code ?fps=N} asks for others. */
    private static final double USUAL_RATE = 10;

    private static final int MOST_RATE = 20;
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final long LOOK_MILLIS = 1000;
    private static final Pattern RATE = Pattern.compile("(?:.*&)?fps=([^&]*)(?:&.*)?");

    private final SceneCache scenes;
    private final CameraPictureCache cameras;
    private final Semaphore places = new Semaphore(MOST);
    private final Set<CameraStream> running = ConcurrentHashMap.newKeySet();
    private final Thread warden = new Thread(this::watch, "camera streams");

    CameraStreams(SceneCache scenes, CameraPictureCache cameras) {
        this.scenes = scenes;
        this.cameras = cameras;
        warden.setDaemon(true);
    }

    void start() {
        warden.start();
    }

    /** Answers with a stream, or with its headers only when no more was asked for. */
    void begin(HttpExchange exchange, String robot) throws IOException, RequestException {
        double rate = rate(exchange.getRequestURI().getRawQuery());
        boolean bare = exchange.getRequestMethod().equals("HEAD");
        if (!bare && !places.tryAcquire()) {
            exchange.getResponseHeaders().set("Retry-After", "5");
            throw new RequestException(WebResponse.UNAVAILABLE, "all " + MOST + " streams are taken, expected later");
        }
        Headers headers = exchange.getResponseHeaders();
        headers.set("Content-Type", "multipart/x-mixed-replace; boundary=" + CameraStream.BOUNDARY);
        headers.set("Cache-Control", "no-store");
        headers.set("X-Content-Type-Options", "nosniff");
        if (bare) {
            exchange.sendResponseHeaders(WebResponse.OK, -1);
            exchange.close();
        } else {
            watch(exchange, robot, rate);
        }
    }

    private void watch(HttpExchange exchange, String robot, double rate) throws IOException {
        try {
            headersOf(exchange);
        } catch (IOException | RuntimeException gone) {
            places.release();
            throw gone;
        }
        CameraStream stream = new CameraStream(exchange, robot, rate, scenes, cameras);
        running.add(stream);
        Thread thread = new Thread(() -> {
            try {
                stream.run();
            } finally {
                running.remove(stream);
                places.release();
            }
        });
        thread.setName("camera stream of " + robot);
        thread.setDaemon(true);
        thread.start();
    }

    /** Of no length known; the connection ends with the stream. */
    private static void headersOf(HttpExchange exchange) throws IOException {
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

    private void watch() {
        try {
            while (true) {
                Thread.sleep(LOOK_MILLIS);
                long now = System.nanoTime();
                running.stream()
                        .filter(stream -> stream.isStuck(now, PATIENCE_NANOS))
                        .forEach(CameraStream::cut);
            }
        } catch (InterruptedException ending) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() {
        warden.interrupt();
        running.forEach(CameraStream::cut);
    }
}
