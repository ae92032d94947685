package simgsm.web;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.concurrent.TimeUnit;

/**
 * A client's connection: requests and answers in turn, on one thread. Another thread closes it when it is late: a request not
 * complete after 3 s, nothing asked for 10 s, or a part of 8 KiB of an answer not taken within the limit.
 */
final class WebConnection implements Runnable, AutoCloseable {
    private static final Logger LOG = System.getLogger(WebConnection.class.getName());
    private static final int PART_OCTETS = 8_192;
    private static final long REQUEST_NANOS = TimeUnit.SECONDS.toNanos(3);
    private static final long IDLE_NANOS = TimeUnit.SECONDS.toNanos(10);
    private static final long LINGER_NANOS = TimeUnit.SECONDS.toNanos(1);
    private static final int MOST_LINGERING_OCTETS = 1 << 20;
    /** RFC 9110, 5.6.7. */
    private static final DateTimeFormatter DATE =
            DateTimeFormatter.ofPattern("EEE, dd MMM yyyy HH:mm:ss 'GMT'", Locale.ENGLISH);

    private final Socket socket;
    private final WebPages pages;
    private final long writeLimitNanos;
    private final long createdNanos = System.nanoTime();
    /** When this connection is late, in nanoseconds after its creation. */
    private volatile long deadlineNanos = REQUEST_NANOS;

    WebConnection(Socket socket, WebPages pages, long writeLimitNanos) {
        this.socket = socket;
        this.pages = pages;
        this.writeLimitNanos = writeLimitNanos;
    }

    private void allow(long nanos) {
        deadlineNanos = System.nanoTime() - createdNanos + nanos;
    }

    /** Closes the connection if it is late. Called by any thread. */
    void closeIfLate() {
        if (System.nanoTime() - createdNanos > deadlineNanos) {
            close();
        }
    }

    @Override
    public void close() {
        try {
            socket.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing a connection: {0}", e.getMessage());
        }
    }

    /** Answers requests until the connection ends. */
    @Override
    public void run() {
        try (socket) {
            socket.setTcpNoDelay(true);
            InputStream in = new BufferedInputStream(socket.getInputStream());
            RequestReader requests = new RequestReader(in);
            while (answerNext(requests)) {
                allow(IDLE_NANOS);
                in.mark(1);
                if (in.read() < 0) {
                    return;
                }
                in.reset();
                allow(REQUEST_NANOS);
            }
            linger(in);
        } catch (IOException ended) {
            LOG.log(Level.DEBUG, "a connection ends: {0}", ended.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** @return whether a further request may follow */
    private boolean answerNext(RequestReader requests) throws IOException, InterruptedException {
        WebRequest request;
        try {
            request = requests.next();
        } catch (RequestException refusal) {
            send(pages.completed(refusal.answer()), false, false);
            return false;
        }
        deadlineNanos = Long.MAX_VALUE;
        WebResponse answer = pages.handle(request);
        boolean goesOn = request.isPersistent()
                && !request.hasBody()
                && answer.stream() == null
                && answer.status() != WebResponse.FAULT;
        send(answer, request.isHead(), goesOn);
        return goesOn;
    }

    private void send(WebResponse answer, boolean headersOnly, boolean goesOn)
            throws IOException, InterruptedException {
        OutputStream out = new BufferedOutputStream(new Parts(), PART_OCTETS);
        try (WebResponse.Stream stream = answer.stream()) {
            StringBuilder head = new StringBuilder(answer.statusLine()).append("\r\n");
            field(head, "Date", DATE.format(ZonedDateTime.now(ZoneOffset.UTC)));
            answer.fields().forEach((name, value) -> field(head, name, value));
            if (stream == null && answer.status() != WebResponse.NOT_MODIFIED) {
                field(head, "Content-Length", Integer.toString(answer.octets().length));
            }
            if (!goesOn) {
                field(head, "Connection", "close");
            }
            out.write(head.append("\r\n").toString().getBytes(StandardCharsets.ISO_8859_1));
            if (!headersOnly) {
                out.write(answer.octets());
            }
            out.flush();
            if (stream != null && !headersOnly) {
                stream.writeTo(out);
                out.flush();
            }
        }
    }

    private static void field(StringBuilder head, String name, String value) {
        head.append(name).append(": ").append(value).append("\r\n");
    }

    /** Reads what the client still sends: closing at once would reset the connection and lose the answer. */
    private void linger(InputStream in) throws IOException {
        socket.shutdownOutput();
        allow(LINGER_NANOS);
        in.skipNBytes(MOST_LINGERING_OCTETS);
    }

    /** Writes in parts, each with the whole limit, so that a slow client keeps its answer. */
    private final class Parts extends OutputStream {
        private final OutputStream out = socket.getOutputStream();

        Parts() throws IOException {
            super();
        }

        @Override
        public void write(int octet) throws IOException {
            write(new byte[] {(byte) octet}, 0, 1);
        }

        @Override
        public void write(byte[] octets, int offset, int length) throws IOException {
            for (int at = 0; at < length; at += PART_OCTETS) {
                allow(writeLimitNanos);
                out.write(octets, offset + at, Math.min(PART_OCTETS, length - at));
            }
            deadlineNanos = Long.MAX_VALUE;
        }
    }
}
