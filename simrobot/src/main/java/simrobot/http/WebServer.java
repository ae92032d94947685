package simrobot.http;

import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Locale;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/** The read-only web server, on the JDK's HTTP server. */
public final class WebServer implements AutoCloseable {
    private static final Logger LOG = System.getLogger(WebServer.class.getName());
    private static final int BACKLOG = 64;
    private static final int WORKERS = 32;
    private static final int MOST_QUEUED = 1024;
    private static final int IDLE_SECONDS = 10;

    static {
        // The JDK's server takes these from system properties only: a connection without a complete request after 10 s
        // is
        // closed, and small responses are sent without delay.
        System.getProperties().putIfAbsent("sun.net.httpserver.maxReqTime", "10");
        System.getProperties().putIfAbsent("sun.net.httpserver.nodelay", "true");
    }

    private final HttpServer server;
    private final ThreadPoolExecutor workers;
    private final CameraStreams streams;

    /**
     * Opens the port; requests are answered after {@link #start}.
     *
     * @param port 0 for any free port
     * @throws IOException with the port's number if it cannot be opened
     */
    public WebServer(InetAddress address, int port, Locale language, WebSource source) throws IOException {
        try {
            server = HttpServer.create(new InetSocketAddress(address, port), BACKLOG);
        } catch (IOException e) {
            throw new IOException("HTTP port " + port + ": " + e.getMessage(), e);
        }
        AtomicInteger count = new AtomicInteger();
        workers = new ThreadPoolExecutor(
                WORKERS, WORKERS, IDLE_SECONDS, TimeUnit.SECONDS, new LinkedBlockingQueue<>(MOST_QUEUED), work -> {
                    Thread thread = new Thread(work, "http " + count.incrementAndGet());
                    thread.setDaemon(true);
                    return thread;
                });
        workers.allowCoreThreadTimeOut(true);
        SceneCache scenes = new SceneCache(source);
        CameraPictureCache cameras = new CameraPictureCache();
        streams = new CameraStreams(scenes, cameras);
        server.setExecutor(workers);
        server.createContext("/", new Router(source, scenes, cameras, streams, new Page(language)));
    }

    public int port() {
        return server.getAddress().getPort();
    }

    public void start() {
        server.start();
        streams.start();
        LOG.log(Level.INFO, "pictures and status on http://{0}:{1}/", host(), Integer.toString(port()));
    }

    private String host() {
        return server.getAddress().getAddress().getHostAddress();
    }

    @Override
    public void close() {
        streams.close();
        server.stop(0);
        workers.shutdownNow();
    }
}
