package simgsm.web;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;

/**
 * A port for HTTP/1.1 with a thread for each connection, at most 512, so that a slow client blocks its own only. Threads end
 * after 10 s without work. A client that reads nothing of its answer loses the connection within 10 s.
 */
public final class WebPort implements AutoCloseable {
    private static final Logger LOG = System.getLogger(WebPort.class.getName());
    private static final int BACKLOG = 64;
    private static final int MOST_CONNECTIONS = 512;
    private static final int IDLE_SECONDS = 10;
    private static final long LONGEST_CHECK_MILLIS = 500;
    private static final long PAUSE_NANOS = 100_000_000;
    /** Less than the 10 s after which a stuck connection ends, by the time of a check. */
    public static final long WRITE_LIMIT_NANOS = TimeUnit.SECONDS.toNanos(8);

    private final ServerSocket server = new ServerSocket();
    private final WebPages pages;
    private final long writeLimitNanos;
    private final ThreadPoolExecutor workers;
    private final Set<WebConnection> connections = ConcurrentHashMap.newKeySet();
    private final Thread acceptor = new Thread(this::accept, "http");
    private final Thread watchdog = new Thread(this::closeLate, "http limits");

    /**
     * Opens the port; requests are answered after {@link #start}.
     *
     * @param port 0 for any free port
     * @throws IOException with the port's number if it cannot be opened
     */
    public WebPort(InetAddress address, int port, WebPages pages) throws IOException {
        this(address, port, pages, WRITE_LIMIT_NANOS);
    }

    /** @param writeLimitNanos how long a connection may take nothing of its answer */
    public WebPort(InetAddress address, int port, WebPages pages, long writeLimitNanos) throws IOException {
        this.pages = pages;
        this.writeLimitNanos = writeLimitNanos;
        try {
            server.bind(new InetSocketAddress(address, port), BACKLOG);
        } catch (IOException e) {
            server.close();
            throw new IOException("HTTP port " + port + ": " + e.getMessage(), e);
        }
        AtomicInteger count = new AtomicInteger();
        workers = new ThreadPoolExecutor(
                0, MOST_CONNECTIONS, IDLE_SECONDS, TimeUnit.SECONDS, new SynchronousQueue<>(), work -> {
                    Thread thread = new Thread(work, "http " + count.incrementAndGet());
                    thread.setDaemon(true);
                    return thread;
                });
        acceptor.setDaemon(true);
        watchdog.setDaemon(true);
    }

    public int port() {
        return server.getLocalPort();
    }

    /** Where the port is: {@code http://127.0.0.1:8080/}. */
    public String url() {
        String host = server.getInetAddress().getHostAddress();
        return "http://" + (host.contains(":") ? "[" + host + "]" : host) + ":" + port() + "/";
    }

    public void start() {
        acceptor.start();
        watchdog.start();
    }

    private void accept() {
        while (!server.isClosed()) {
            try {
                serve(server.accept());
            } catch (IOException e) {
                pauseAfter(e);
            }
        }
    }

    /** The process may have no file descriptor left; a later client may get one. */
    private void pauseAfter(IOException failure) {
        if (!server.isClosed()) {
            LOG.log(Level.WARNING, "accepting a web client: " + failure.getMessage());
            LockSupport.parkNanos(PAUSE_NANOS);
        }
    }

    private void serve(Socket socket) {
        WebConnection connection = new WebConnection(socket, pages, writeLimitNanos);
        connections.add(connection);
        try {
            workers.execute(() -> {
                try (connection) {
                    connection.run();
                } finally {
                    connections.remove(connection);
                }
            });
        } catch (RejectedExecutionException full) {
            connections.remove(connection);
            connection.close();
        }
    }

    private void closeLate() {
        long periodMillis = Math.min(LONGEST_CHECK_MILLIS, TimeUnit.NANOSECONDS.toMillis(writeLimitNanos) + 1);
        try {
            while (true) {
                Thread.sleep(periodMillis);
                connections.forEach(WebConnection::closeIfLate);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() {
        try {
            server.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing the web port: {0}", e.getMessage());
        }
        watchdog.interrupt();
        workers.shutdownNow();
        connections.forEach(WebConnection::close);
    }
}
