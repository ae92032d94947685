package simgsm.web;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpHandler;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Answers requests to this machine by their path, with 405 to a method that the path does not accept. Pages of this
 * machine may read the answers to GET and HEAD; other methods require the same origin. An error is answered with its
 * reason as JSON; an internal error closes the connection and is logged.
 */
public abstract class WebPages implements HttpHandler {
    private static final Logger LOG = System.getLogger(WebPages.class.getName());

    private static final List<String> READING = List.of("GET", "HEAD");
    private static final String SCHEME = "Bearer ";

    private final String policy;
    private final boolean admitsEveryHost;
    /** Null on a port without WebSockets. */
    private volatile WebDoor door;

    /** @param policy of loading and running (Content-Security-Policy) */
    protected WebPages(String policy) {
        this(policy, false);
    }

    /**
     * @param policy as above
     * @param admitsEveryHost true to accept any host name; only for pages that show nothing without a key
     */
    protected WebPages(String policy, boolean admitsEveryHost) {
        this.policy = policy;
        this.admitsEveryHost = admitsEveryHost;
    }

    void setDoor(WebDoor passing) {
        door = passing;
    }

    /** The client of a request: its own address, not that of the connection made by the door. */
    protected final InetSocketAddress client(HttpExchange exchange) {
        InetSocketAddress seen = exchange.getRemoteAddress();
        return door == null ? seen : door.client(seen);
    }

    /**
     * The operator of a request's key.
     *
     * @throws RequestException with status 401 without a right key, 429 after too many wrong ones
     */
    protected final String operator(HttpExchange exchange, AccessKeys keys) throws RequestException {
        String given = Objects.requireNonNullElse(exchange.getRequestHeaders().getFirst("Authorization"), "");
        if (!given.regionMatches(true, 0, SCHEME, 0, SCHEME.length())) {
            throw new RequestException(WebResponse.UNAUTHORIZED, "expected a key as Authorization: Bearer KEY");
        }
        return keys.operator(
                given.substring(SCHEME.length()).strip(), client(exchange).getAddress(), System.nanoTime());
    }

    /** The methods accepted by a path. */
    protected List<String> methods(List<String> parts) {
        return READING;
    }

    /**
     * The answer to a request.
     *
     * @param parts the segments of the path, decoded
     * @param path as requested, for error texts
     * @return empty if the exchange was taken over, for a stream
     * @throws RequestException for any other status than success
     * @throws IllegalStateException if the program does not answer: status 503
     */
    protected abstract Optional<WebResponse> answer(HttpExchange exchange, List<String> parts, String path)
            throws IOException, InterruptedException, RequestException;

    @Override
    public final void handle(HttpExchange exchange) throws IOException {
        String path = Objects.requireNonNullElse(exchange.getRequestURI().getRawPath(), "");
        try {
            List<String> parts = UrlPaths.parts(path);
            requireMethod(exchange, methods(parts));
            if (!admitsEveryHost) {
                Origins.requireOwnHost(exchange.getRequestHeaders().getFirst("Host"));
            }
            Origins.admit(exchange);
            if (!READING.contains(exchange.getRequestMethod())) {
                Headers headers = exchange.getRequestHeaders();
                Origins.requireSameOrigin(headers.getFirst("Host"), headers.getFirst("Origin"));
            }
            Optional<WebResponse> answer = answer(exchange, parts, path);
            if (answer.isPresent()) {
                send(exchange, answer.get());
            }
        } catch (RequestException refusal) {
            send(exchange, refusal.answer());
        } catch (IllegalStateException noAnswer) {
            send(exchange, WebResponse.error(WebResponse.UNAVAILABLE, noAnswer.getMessage()));
        } catch (IllegalArgumentException malformed) {
            send(
                    exchange,
                    WebResponse.error(WebResponse.BAD_REQUEST, "malformed path " + RequestException.shortened(path)));
        } catch (InterruptedException e) {
            exchange.close();
            Thread.currentThread().interrupt();
        } catch (RuntimeException fault) {
            LOG.log(Level.ERROR, "answering " + path + " failed", fault);
            exchange.close();
        }
    }

    private static void requireMethod(HttpExchange exchange, List<String> allowed) throws RequestException {
        String method = exchange.getRequestMethod();
        if (!allowed.contains(method)) {
            exchange.getResponseHeaders().set("Allow", String.join(", ", allowed));
            throw new RequestException(
                    WebResponse.METHOD_NOT_ALLOWED,
                    "method " + method + " is not allowed, expected " + String.join(" or ", allowed));
        }
    }

    private void send(HttpExchange exchange, WebResponse answer) throws IOException {
        boolean headersOnly = exchange.getRequestMethod().equals("HEAD");
        Headers headers = exchange.getResponseHeaders();
        headers.set("Content-Type", answer.type());
        headers.set("Cache-Control", headers.containsKey("ETag") ? "no-cache" : "no-store");
        headers.set("X-Content-Type-Options", "nosniff");
        headers.set("Content-Security-Policy", policy);
        if (answer.status() == WebResponse.UNAUTHORIZED) {
            headers.set("WWW-Authenticate", "Bearer");
        } else if (answer.status() == WebResponse.TOO_MANY_REQUESTS) {
            headers.set("Retry-After", "1");
        }
        try (exchange) {
            if (answer.status() == WebResponse.NOT_MODIFIED) {
                exchange.sendResponseHeaders(answer.status(), -1);
            } else if (headersOnly) {
                headers.set("Content-Length", Integer.toString(answer.body().length));
                exchange.sendResponseHeaders(answer.status(), -1);
            } else {
                exchange.sendResponseHeaders(answer.status(), answer.body().length);
                try (OutputStream body = exchange.getResponseBody()) {
                    body.write(answer.body());
                }
            }
        }
    }
}
