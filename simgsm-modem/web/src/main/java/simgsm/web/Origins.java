package simgsm.web;

import com.sun.net.httpserver.HttpExchange;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Checks of the pages that may read. Against DNS rebinding, requests must name this machine; a page on this machine
 * may read all answers.
 */
final class Origins {
    /** An address or localhost, with or without a port. */
    private static final Pattern ADDRESS = Pattern.compile(
            "(localhost|[0-9]{1,3}(\\.[0-9]{1,3}){3}|\\[[0-9a-f:.%]+\\])(:[0-9]+)?", Pattern.CASE_INSENSITIVE);

    private static final Pattern LOCAL_PAGE =
            Pattern.compile("https?://(localhost|127\\.0\\.0\\.1|\\[::1\\])(:[0-9]+)?");

    private static final String OWN_NAME = ownName();

    private Origins() {}

    private static String ownName() {
        try {
            return InetAddress.getLocalHost().getHostName();
        } catch (UnknownHostException e) {
            return "localhost";
        }
    }

    /** @throws RequestException if the request names another host */
    static void requireOwnHost(String host) throws RequestException {
        // Without a name it is not from a browser.
        if (host != null
                && !ADDRESS.matcher(host).matches()
                && !host.replaceFirst(":[0-9]+$", "").equalsIgnoreCase(OWN_NAME)) {
            throw new RequestException(
                    WebResponse.FORBIDDEN,
                    "the host of the request is not this machine, expected localhost or an address");
        }
    }

    /**
     * Refuses a page of another site, which could open a WebSocket to this machine or post to it: the origin must be
     * the requested host.
     *
     * @param host null if the request names none; so is origin
     */
    static void requireSameOrigin(String host, String origin) throws RequestException {
        if (origin != null && !origin.replaceFirst("^https?://", "").equalsIgnoreCase(host)) {
            throw new RequestException(WebResponse.FORBIDDEN, "the request comes from a page of another host");
        }
    }

    /** True if a request has no page's origin, or that of a page of this machine. */
    static boolean isLocal(Optional<String> origin) {
        return origin.map(each -> LOCAL_PAGE.matcher(each).matches()).orElse(true);
    }

    /** Permits a page of this machine to read the answer. */
    static void admit(HttpExchange exchange) {
        String origin = exchange.getRequestHeaders().getFirst("Origin");
        exchange.getResponseHeaders().add("Vary", "Origin");
        if (origin != null && isLocal(Optional.of(origin))) {
            exchange.getResponseHeaders().set("Access-Control-Allow-Origin", origin);
        }
    }
}
