package simgsm.web;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Answers GET and HEAD requests to this machine by their path, every other one with 405; pages of this machine may read the
 * answers. Every error is answered with its reason as JSON; one of our own is logged, too.
 */
public abstract class WebPages {
    private static final Logger LOG = System.getLogger(WebPages.class.getName());

    private final String policy;

    /** @param policy what pages may load and run (Content-Security-Policy) */
    protected WebPages(String policy) {
        this.policy = policy;
    }

    /**
     * The answer to a request.
     *
     * @param parts the segments of the path, decoded
     * @throws RequestException for anything but a success
     * @throws IllegalStateException if the program does not answer: status 503
     */
    protected abstract WebResponse answer(WebRequest request, List<String> parts)
            throws IOException, InterruptedException, RequestException;

    /** The whole answer to a request. */
    final WebResponse handle(WebRequest request) throws InterruptedException {
        try {
            requireGetOrHead(request);
            Origins.requireOwnHost(request);
        } catch (RequestException refusal) {
            return completed(refusal.answer());
        }
        return completed(Origins.admit(request, answered(request)));
    }

    private WebResponse answered(WebRequest request) throws InterruptedException {
        try {
            return answer(request, parts(request.path()));
        } catch (RequestException refusal) {
            return refusal.answer();
        } catch (IllegalStateException noAnswer) {
            return WebResponse.error(WebResponse.UNAVAILABLE, noAnswer.getMessage());
        } catch (IOException | RuntimeException fault) {
            LOG.log(Level.ERROR, "answering " + RequestException.shortened(request.path()) + " failed", fault);
            return WebResponse.error(WebResponse.FAULT, "the request cannot be answered; the log has the reason");
        }
    }

    private static List<String> parts(String path) throws RequestException {
        try {
            return UrlPaths.parts(path);
        } catch (IllegalArgumentException malformed) {
            throw new RequestException(
                    WebResponse.BAD_REQUEST, "malformed path " + RequestException.shortened(path) + ", expected %XX");
        }
    }

    private static void requireGetOrHead(WebRequest request) throws RequestException {
        if (!request.method().equals("GET") && !request.isHead()) {
            throw new RequestException(
                    WebResponse.METHOD_NOT_ALLOWED,
                    "method " + RequestException.shortened(request.method()) + " is not allowed, expected GET or HEAD");
        }
    }

    /** With the header fields that all answers have. */
    final WebResponse completed(WebResponse answer) {
        Map<String, String> fields = new HashMap<>(answer.fields());
        fields.put("Cache-Control", fields.containsKey("ETag") ? "no-cache" : "no-store");
        fields.put("X-Content-Type-Options", "nosniff");
        fields.put("Content-Security-Policy", policy);
        if (answer.status() == WebResponse.METHOD_NOT_ALLOWED) {
            fields.put("Allow", "GET, HEAD");
        }
        return new WebResponse(answer.status(), fields, answer.octets(), answer.stream());
    }
}
