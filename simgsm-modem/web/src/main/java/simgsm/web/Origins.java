package simgsm.web;

import com.sun.net.httpserver.HttpExchange;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.regex.Pattern;

/**
 * Which pages may read. A page from elsewhere must not reach this server under a name that it makes point here, so requests
 * name this machine; a page on this machine may read what is served.
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
        // without a name no browser sent it
        if (host != null
                && !ADDRESS.matcher(host).matches()
                && !host.replaceFirst(":[0-9]+$", "").equalsIgnoreCase(OWN_NAME)) {
            throw new RequestException(
                    WebResponse.FORBIDDEN,
                    "the host of the request is not this machine, expected localhost or an address");
        }
    }

    /**
     * A page of another site may open a WebSocket to this machine, or post to it, so its origin must be the host that it asks.
     *
     * @param host null if the request names none, as the origin
     */
    static void requireSameOrigin(String host, String origin) throws RequestException {
        if (origin != null && !origin.replaceFirst("^https?://", "").equalsIgnoreCase(host)) {
            throw new RequestException(WebResponse.FORBIDDEN, "the request comes from a page of another host");
        }
    }

    /** True if a request comes from no page, or from a page of this machine. */
    static boolean isLocal(Optional<String> origin) {
        return origin.map(each -> LOCAL_PAGE.matcher(each).matches()).orElse(true);
    }

    /** Lets a page of this machine read the answer. */
    static void admit(HttpExchange exchange) {
        String origin = exchange.getRequestHeaders().getFirst("Origin");
        exchange.getResponseHeaders().add("Vary", "Origin");
        if (origin != null && isLocal(Optional.of(origin))) {
            exchange.getResponseHeaders().set("Access-Control-Allow-Origin", origin);
        }
    }
}
