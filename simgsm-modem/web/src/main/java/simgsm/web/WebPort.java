package simgsm.web;

import com.sun.net.httpserver.HttpHandler;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * A port for HTTP, with at most 512 threads that end after 10 s without work. A client that reads nothing of its answer loses
 * the connection within 10 s.
 */
public final class WebPort implements AutoCloseable {
    private static final int BACKLOG = 64;

    /** A thread for each request: a connection that sends half a request blocks its own only. */
    private static final int MOST_WORKERS = 512;

    private static final int IDLE_SECONDS = 10;
    /** Less than the 10 s after which a stuck connection ends, by the time of a look. */
    public static final long WRITE_LIMIT_NANOS = TimeUnit.SECONDS.toNanos(8);

    static {
        // The JDK's server takes these from system properties only: a connection without a complete request after 3 s
        // is closed, and small responses are sent without delay.
        System.getProperties().putIfAbsent("sun.net.httpserver.maxReqTime", "3");
        System.getProperties().putIfAbsent("sun.net.httpserver.nodelay", "true");
    }

    private final HttpServer server;
    private final ThreadPoolExecutor workers;
    private final WriteLimit writeLimit;

    /**
     * Opens the port; requests are answered after {@link #start}.
     *
     * @param port 0 for any free port
     * @throws IOException with the port's number if it cannot be opened
     */
    public WebPort(InetAddress address, int port, HttpHandler pages) throws IOException {
        this(address, port, pages, WRITE_LIMIT_NANOS);
    }

    /** @param writeLimitNanos how long a connection may take nothing of its answer */
    public WebPort(InetAddress address, int port, HttpHandler pages, long writeLimitNanos) throws IOException {
        writeLimit = new WriteLimit(writeLimitNanos);
        try {
            server = HttpServer.create(new InetSocketAddress(address, port), BACKLOG);
        } catch (IOException e) {
            throw new IOException("HTTP port " + port + ": " + e.getMessage(), e);
        }
        AtomicInteger count = new AtomicInteger();
        workers = new ThreadPoolExecutor(
                0, MOST_WORKERS, IDLE_SECONDS, TimeUnit.SECONDS, new SynchronousQueue<>(), work -> {
                    Thread thread = new Thread(work, "http " + count.incrementAndGet());
                    thread.setDaemon(true);
                    return thread;
                });
        server.setExecutor(workers);
        server.createContext("/", pages).getFilters().add(writeLimit);
    }

    public int port() {
        return server.getAddress().getPort();
    }

    /** Where the port is: {@code http://127.0.0.1:8080/}. */
    public String url() {
        InetAddress address = server.getAddress().getAddress();
        String host = address.getHostAddress();
        return "http://" + (host.contains(":") ? "[" + host + "]" : host) + ":" + port() + "/";
    }

    public void start() {
        server.start();
        writeLimit.start();
    }

    @Override
    public void close() {
        writeLimit.close();
        server.stop(0);
        workers.shutdownNow();
    }
}
