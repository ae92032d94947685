package simgsm.gateway;

import java.io.IOException;
import java.io.InputStream;
import java.lang.System.Logger.Level;
import java.net.HttpURLConnection;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import simgsm.web.JsonReader;
import simgsm.web.RequestException;
import simgsm.web.UrlPaths;
import simgsm.web.WebResponse;

/**
 * The robots' states and pictures for the pages, fetched from SimRobots' web servers, so that browsers need no second
 * port.
 */
final class RobotPages {
    private static final int TIMEOUT_MILLIS = 3_000;
    private static final int MOST_OCTETS = 8 * 1024 * 1024;

    private static final System.Logger LOG = System.getLogger(RobotPages.class.getName());

    /** Each page requests the robots once a second, and each picture needs its robot's server. */
    private static final long KEPT_NANOS = TimeUnit.MILLISECONDS.toNanos(200);

    /** @param items the elements of a server's JSON array */
    private record Listing(String items, Set<Object> names, long fetchedNanos) {}

    private final List<URI> servers;
    private final Map<URI, Listing> listings = new ConcurrentHashMap<>();
    /** Servers already logged as not answering. */
    private final Set<URI> absent = ConcurrentHashMap.newKeySet();

    RobotPages(List<URI> servers) {
        this.servers = servers;
    }

    /** @param parts of the path after {@code /robots}: none, a robot's name, or that and one of its pictures */
    WebResponse answer(List<String> parts, String path) throws RequestException {
        if (parts.isEmpty()) {
            return WebResponse.json(all());
        }
        URI server = servers.stream()
                .filter(each -> listing(each).names().contains(parts.get(0)))
                .findFirst()
                .orElseThrow(() -> RequestException.notFound(path, "the name of a robot"));
        String robot = "robots/" + UrlPaths.encoded(parts.get(0));
        if (parts.size() == 1) {
            return fetch(server, robot);
        }
        return switch (parts.get(1)) {
            case "camera.jpg" -> fetch(server, robot + "/camera.jpg");
            case "map.svg" -> fetch(server, "map.svg");
            case "lane.svg" -> fetch(server, robot + "/map.svg");
            default -> throw RequestException.notFound(path, "camera.jpg, map.svg or lane.svg of a robot");
        };
    }

    private String all() {
        return servers.stream()
                .map(server -> listing(server).items())
                .filter(items -> !items.isBlank())
                .collect(Collectors.joining(",", "[", "]"));
    }

    /** The robots of a server; none while it does not answer. */
    private Listing listing(URI server) {
        Listing kept = listings.get(server);
        if (kept != null && System.nanoTime() - kept.fetchedNanos() < KEPT_NANOS) {
            return kept;
        }
        Listing fetched = fetchListing(server);
        listings.put(server, fetched);
        return fetched;
    }

    private Listing fetchListing(URI server) {
        try {
            String list = new String(fetch(server, "robots").body(), StandardCharsets.UTF_8).strip();
            if (JsonReader.parse(list) instanceof List<?> robots) {
                absent.remove(server);
                Set<Object> names = robots.stream()
                        .map(robot -> robot instanceof Map<?, ?> fields ? fields.get("name") : null)
                        .filter(Objects::nonNull)
                        .collect(Collectors.toSet());
                return new Listing(list.substring(1, list.length() - 1), names, System.nanoTime());
            }
        } catch (RequestException | IllegalArgumentException e) {
            // a SimRobot that does not answer has no robots for now
        }
        if (absent.add(server)) {
            LOG.log(Level.WARNING, "--robots {0}: no SimRobot answers; trying again", server);
        }
        return new Listing("", Set.of(), System.nanoTime());
    }

    private static WebResponse fetch(URI server, String path) throws RequestException {
        try {
            HttpURLConnection connection =
                    (HttpURLConnection) server.resolve(path).toURL().openConnection();
            connection.setConnectTimeout(TIMEOUT_MILLIS);
            connection.setReadTimeout(TIMEOUT_MILLIS);
            connection.setInstanceFollowRedirects(false);
            int status = connection.getResponseCode();
            if (connection.getErrorStream() != null) {
                connection.disconnect();
            }
            if (status == WebResponse.NOT_FOUND) {
                throw RequestException.notFound(path, "what the robot's program serves");
            }
            try (InputStream in = connection.getInputStream()) {
                return new WebResponse(WebResponse.OK, connection.getContentType(), in.readNBytes(MOST_OCTETS));
            }
        } catch (IOException e) {
            throw new RequestException(WebResponse.UNAVAILABLE, "the robot's program does not answer");
        }
    }
}
