package simgsm.web;

import com.sun.net.httpserver.Filter;
import com.sun.net.httpserver.HttpExchange;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import simgsm.thread.DaemonThread;

/**
 * Ends every answer that its client does not read: a write of up to 8 KiB that exceeds the limit is interrupted, and
 * the JDK's server then closes the connection.
 */
final class WriteLimit extends Filter implements AutoCloseable {
    private static final int PART_OCTETS = 8_192;
    private static final long CHECK_MILLIS = 1_000;

    private final long limitNanos;
    /** Start of each thread's write, by {@link System#nanoTime}. */
    private final Map<Thread, Long> writing = new ConcurrentHashMap<>();

    private final Thread watchdog = DaemonThread.of("http write limit", this::watch);

    WriteLimit(long limitNanos) {
        this.limitNanos = limitNanos;
    }

    void start() {
        watchdog.start();
    }

    @Override
    public String description() {
        return "closes connections that take nothing";
    }

    @Override
    public void doFilter(HttpExchange exchange, Chain chain) throws IOException {
        exchange.getRequestBody(); // the JDK's server takes another output stream only after this
        exchange.setStreams(null, limited(exchange.getResponseBody()));
        chain.doFilter(exchange);
    }

    OutputStream limited(OutputStream out) {
        return new LimitedOutput(out);
    }

    private void watch() throws InterruptedException {
        while (true) {
            Thread.sleep(CHECK_MILLIS);
            long now = System.nanoTime();
            for (Thread thread : writing.keySet()) {
                writing.computeIfPresent(thread, (writer, since) -> interruptLate(writer, now - since) ? null : since);
            }
        }
    }

    private boolean interruptLate(Thread writer, long nanos) {
        boolean isLate = nanos > limitNanos;
        if (isLate) {
            writer.interrupt();
        }
        return isLate;
    }

    @Override
    public void close() {
        watchdog.interrupt();
    }

    private interface Output {
        void run() throws IOException;
    }

    private final class LimitedOutput extends FilterOutputStream {
        LimitedOutput(OutputStream out) {
            super(out);
        }

        private void limited(Output output) throws IOException {
            writing.put(Thread.currentThread(), System.nanoTime());
            try {
                output.run();
            } finally {
                writing.remove(Thread.currentThread());
            }
        }

        @Override
        public void write(int octet) throws IOException {
            limited(() -> out.write(octet));
        }

        @Override
        public void write(byte[] octets, int offset, int length) throws IOException {
            for (int at = 0; at < length; at += PART_OCTETS) {
                int from = offset + at;
                int count = Math.min(PART_OCTETS, length - at);
                limited(() -> out.write(octets, from, count));
            }
        }

        @Override
        public void flush() throws IOException {
            limited(out::flush);
        }

        @Override
        public void close() throws IOException {
            limited(out::close);
        }
    }
}
