package simgsm.web;

import com.sun.net.httpserver.HttpHandler;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketException;
import java.util.List;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import simgsm.net.Acceptor;
import simgsm.net.ConnectionLimits;
import simgsm.net.ReachableAddresses;
import simgsm.thread.DaemonThread;

/**
 * A port for HTTP and, at given paths, WebSockets. HTTP is served by at most 512 threads, which end after 10 s
 * without work. A client that does not read its answer is disconnected within 10 s.
 */
public final class WebPort implements AutoCloseable {
    private static final int BACKLOG = 64;

    /** One thread per request: a connection that sends half a request blocks only its own. */
    private static final int MOST_WORKERS = 512;

    private static final int MOST_CONNECTIONS = 1_024;
    /** A class behind a router has one address. */
    private static final int MOST_PER_ADDRESS = 400;

    private static final int IDLE_SECONDS = 10;
    /** Less than 10 s, the limit of a stuck connection, by the period of the check. */
    public static final long WRITE_LIMIT_NANOS = TimeUnit.SECONDS.toNanos(8);

    static {
        // The JDK's server reads these from system properties only: a connection without a complete request after 3 s
        // is closed, and small responses are sent without delay.
        System.getProperties().putIfAbsent("sun.net.httpserver.maxReqTime", "3");
        System.getProperties().putIfAbsent("sun.net.httpserver.nodelay", "true");
    }

    /** Opens a port on a loop's thread. */
    public interface Listening {
        Acceptor listen(InetSocketAddress address, ConnectionLimits limits, Acceptor.Factory factory)
                throws IOException;
    }

    private final HttpServer server;
    /** Null without WebSockets: the HTTP server has the port itself. */
    private Acceptor acceptor;

    private InetSocketAddress address;
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

    /**
     * Opens a port for pages and WebSockets; both are answered after {@link #start}.
     *
     * @param loop its thread owns the WebSockets
     * @param admitsEveryHost see {@link WebPages}
     * @throws IOException naming address and port
     */
    public WebPort(
            Listening loop,
            InetSocketAddress address,
            WebPages pages,
            List<WebSocketPath> sockets,
            boolean admitsEveryHost)
            throws IOException {
        this(InetAddress.getLoopbackAddress(), 0, pages);
        WebDoor door = new WebDoor(server.getAddress(), sockets, admitsEveryHost);
        pages.setDoor(door);
        acceptor = loop.listen(address, new ConnectionLimits(MOST_CONNECTIONS, MOST_PER_ADDRESS), door);
        this.address = new InetSocketAddress(address.getAddress(), acceptor.port());
    }

    /** @param writeLimitNanos longest time without progress of an answer */
    public WebPort(InetAddress address, int port, HttpHandler pages, long writeLimitNanos) throws IOException {
        writeLimit = new WriteLimit(writeLimitNanos);
        try {
            server = HttpServer.create(new InetSocketAddress(address, port), BACKLOG);
        } catch (IOException e) {
            throw new IOException("HTTP port " + port + ": " + e.getMessage(), e);
        }
        this.address = server.getAddress();
        AtomicInteger count = new AtomicInteger();
        workers = new ThreadPoolExecutor(
                0,
                MOST_WORKERS,
                IDLE_SECONDS,
                TimeUnit.SECONDS,
                new SynchronousQueue<>(),
                work -> DaemonThread.of("http " + count.incrementAndGet(), work::run));
        server.setExecutor(workers);
        server.createContext("/", pages).getFilters().add(writeLimit);
    }

    public int port() {
        return address.getPort();
    }

    /**
     * The port's address: {@code http://127.0.0.1:8080/}; for a port on all addresses, that of this machine in its
     * network.
     */
    public String url() {
        String host = host();
        return "http://" + (host.contains(":") ? "[" + host + "]" : host) + ":" + port() + "/";
    }

    private String host() {
        try {
            return ReachableAddresses.of(address.getAddress()).get(0);
        } catch (SocketException unknown) {
            return InetAddress.getLoopbackAddress().getHostAddress();
        }
    }

    public void start() {
        server.start();
        writeLimit.start();
    }

    @Override
    public void close() {
        if (acceptor != null) {
            acceptor.close();
        }
        writeLimit.close();
        server.stop(0);
        workers.shutdownNow();
    }
}
