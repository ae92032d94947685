package simgsm.web;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpHandler;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Answers GET and HEAD requests to this machine by their path, every other one with 405; pages of this machine may read the
 * answers; an error is answered with its reason as JSON, an error
 * of our own closes the connection and is logged.
 */
public abstract class WebPages implements HttpHandler {
    private static final Logger LOG = System.getLogger(WebPages.class.getName());

    private final String policy;
    private final boolean admitsEveryHost;

    /** @param policy what pages may load and run (Content-Security-Policy) */
    protected WebPages(String policy) {
        this(policy, false);
    }

    /**
     * @param policy as above
     * @param admitsEveryHost whether requests may name this machine as they like; only for pages that show nothing without
     *     a key
     */
    protected WebPages(String policy, boolean admitsEveryHost) {
        this.policy = policy;
        this.admitsEveryHost = admitsEveryHost;
    }

    /**
     * The answer to a request.
     *
     * @param parts the segments of the path, decoded
     * @param path as requested, for error texts
     * @return empty if the exchange was taken over, for a stream
     * @throws RequestException for anything but a success
     * @throws IllegalStateException if the program does not answer: status 503
     */
    protected abstract Optional<WebResponse> answer(HttpExchange exchange, List<String> parts, String path)
            throws IOException, InterruptedException, RequestException;

    @Override
    public final void handle(HttpExchange exchange) throws IOException {
        String path = Objects.requireNonNullElse(exchange.getRequestURI().getRawPath(), "");
        try {
            requireGetOrHead(exchange);
            if (!admitsEveryHost) {
                Origins.requireOwnHost(exchange.getRequestHeaders().getFirst("Host"));
            }
            Origins.admit(exchange);
            Optional<WebResponse> answer = answer(exchange, UrlPaths.parts(path), path);
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

    private static void requireGetOrHead(HttpExchange exchange) throws RequestException {
        String method = exchange.getRequestMethod();
        if (!method.equals("GET") && !method.equals("HEAD")) {
            exchange.getResponseHeaders().set("Allow", "GET, HEAD");
            throw new RequestException(
                    WebResponse.METHOD_NOT_ALLOWED, "method " + method + " is not allowed, expected GET or HEAD");
        }
    }

    private void send(HttpExchange exchange, WebResponse answer) throws IOException {
        boolean headersOnly = exchange.getRequestMethod().equals("HEAD");
        Headers headers = exchange.getResponseHeaders();
        headers.set("Content-Type", answer.type());
        headers.set("Cache-Control", headers.containsKey("ETag") ? "no-cache" : "no-store");
        headers.set("X-Content-Type-Options", "nosniff");
        headers.set("Content-Security-Policy", policy);
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
