package simgsm.cells.net;

import java.io.IOException;
import java.io.InputStream;
import java.lang.System.Logger.Level;
import java.net.HttpURLConnection;
import java.net.URI;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.cells.town.TownPlace;
import simgsm.thread.DaemonThread;

/**
 * Reads the pose of a robot from a SimRobot's web server twice a second, on a separate thread.
 *
 * @param number of the terminal at its place;
 * @param url {@code http://HOST:PORT/robots/NAME}
 * @param scale metres of the town per metre of the robot's world
 */
public record FollowedRobot(String number, URL url, double scale) {
    private static final System.Logger LOG = System.getLogger(FollowedRobot.class.getName());
    private static final long PERIOD_MILLIS = 500;
    private static final int TIMEOUT_MILLIS = 2_000;
    private static final int MOST_OCTETS = 65_536;
    private static final String NUMBER = "(-?[0-9]+(?:\\.[0-9]+)?(?:[eE][-+]?[0-9]+)?)";
    private static final Pattern POSE = Pattern.compile("\"x\":\\s*" + NUMBER + ",\\s*\"y\":\\s*" + NUMBER);

    /**
     * Parses {@code NUMBER=URL[,SCALE]}.
     *
     * @throws IllegalArgumentException naming the expected text
     */
    public static FollowedRobot parse(String text) {
        Matcher parts = Pattern.compile(
                        "([0-9]{1,15})=(http://[^,]+/robots/[^,/]+)(?:,([0-9]{1,6}(?:\\.[0-9]{1,6})?))?")
                .matcher(text);
        if (!parts.matches()) {
            throw new IllegalArgumentException(
                    "--follow: expected NUMBER=URL[,SCALE], as 5550200=http://127.0.0.1:8080/robots/robot,100, found "
                            + text);
        }
        try {
            return new FollowedRobot(
                    parts.group(1),
                    URI.create(parts.group(2)).toURL(),
                    parts.group(3) == null ? 1 : Double.parseDouble(parts.group(3)));
        } catch (IOException | IllegalArgumentException e) {
            throw new IllegalArgumentException("--follow: expected a URL, found " + parts.group(2));
        }
    }

    /**
     * Starts following.
     *
     * @param moved receives each new place
     */
    public void start(Consumer<TownPlace> moved) {
        DaemonThread.start("pose of " + number, () -> follow(moved));
    }

    private void follow(Consumer<TownPlace> moved) throws InterruptedException {
        boolean isFailureLogged = false;
        TownPlace last = null;
        while (!Thread.currentThread().isInterrupted()) {
            try {
                TownPlace place = read();
                isFailureLogged = false;
                if (!place.equals(last)) {
                    moved.accept(place);
                    last = place;
                }
            } catch (IOException e) {
                if (!isFailureLogged) {
                    LOG.log(Level.WARNING, "{0}: no pose from {1} ({2}); trying again", number, url, e.getMessage());
                    isFailureLogged = true;
                }
            }
            Thread.sleep(PERIOD_MILLIS);
        }
    }

    private TownPlace read() throws IOException {
        HttpURLConnection connection = (HttpURLConnection) url.openConnection();
        connection.setConnectTimeout(TIMEOUT_MILLIS);
        connection.setReadTimeout(TIMEOUT_MILLIS);
        try (InputStream in = connection.getInputStream()) {
            return placeIn(new String(in.readNBytes(MOST_OCTETS), StandardCharsets.UTF_8));
        } finally {
            connection.disconnect();
        }
    }

    TownPlace placeIn(String json) throws IOException {
        Matcher pose = POSE.matcher(json);
        if (!pose.find()) {
            throw new IOException("expected a pose, \"x\":...,\"y\":..., in the answer");
        }
        return new TownPlace(scale * Double.parseDouble(pose.group(1)), scale * Double.parseDouble(pose.group(2)));
    }
}
