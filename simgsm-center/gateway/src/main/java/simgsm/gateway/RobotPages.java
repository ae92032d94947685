package simgsm.gateway;

import java.io.IOException;
import java.io.InputStream;
import java.lang.System.Logger.Level;
import java.net.HttpURLConnection;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import simgsm.web.JsonReader;
import simgsm.web.RequestException;
import simgsm.web.UrlPaths;
import simgsm.web.WebResponse;

/** What the pages show of the robots, fetched from the web servers of SimRobots: browsers need no second port. */
final class RobotPages {
    private static final int TIMEOUT_MILLIS = 3_000;
    private static final int MOST_OCTETS = 8 * 1024 * 1024;

    private static final System.Logger LOG = System.getLogger(RobotPages.class.getName());

    private final List<URI> servers;
    /** Those of which it is logged that they do not answer. */
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
                .filter(each -> hasRobot(each, parts.get(0)))
                .findFirst()
                .orElseThrow(() -> RequestException.notFound(path, "the name of a robot"));
        String robot = "robots/" + UrlPaths.encoded(parts.get(0));
        if (parts.size() == 1) {
            return fetch(server, robot);
        }
        return switch (parts.get(1)) {
            case "camera.jpg" -> fetch(server, robot + "/camera.jpg");
            case "map.svg" -> fetch(server, "map.svg");
            default -> throw RequestException.notFound(path, "camera.jpg or map.svg of a robot");
        };
    }

    private String all() {
        StringBuilder joined = new StringBuilder("[");
        for (URI server : servers) {
            try {
                String list = new String(fetch(server, "robots").body(), StandardCharsets.UTF_8).strip();
                if (JsonReader.parse(list) instanceof List<?> robots && !robots.isEmpty()) {
                    joined.append(joined.length() > 1 ? "," : "").append(list, 1, list.length() - 1);
                }
                absent.remove(server);
            } catch (RequestException | IllegalArgumentException e) {
                if (absent.add(server)) {
                    LOG.log(Level.WARNING, "--robots {0}: no SimRobot answers; trying again", server);
                }
            }
        }
        return joined.append(']').toString();
    }

    private static boolean hasRobot(URI server, String name) {
        try {
            Object list = JsonReader.parse(new String(fetch(server, "robots").body(), StandardCharsets.UTF_8));
            return ((List<?>) list).stream().anyMatch(robot -> name.equals(((Map<?, ?>) robot).get("name")));
        } catch (RequestException | ClassCastException | IllegalArgumentException e) {
            return false; // As above.
        }
    }

    private static WebResponse fetch(URI server, String path) throws RequestException {
        try {
            HttpURLConnection connection =
                    (HttpURLConnection) server.resolve(path).toURL().openConnection();
            connection.setConnectTimeout(TIMEOUT_MILLIS);
            connection.setReadTimeout(TIMEOUT_MILLIS);
            connection.setInstanceFollowRedirects(false);
            if (connection.getResponseCode() == WebResponse.NOT_FOUND) {
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
