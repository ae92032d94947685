package simrobot.http;

import java.util.Optional;
import java.util.concurrent.Semaphore;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simgsm.web.RequestException;
import simgsm.web.WebRequest;
import simgsm.web.WebResponse;

/** The camera streams of all clients, at most 16. */
final class CameraStreams {
    static final int MOST = 16;

    /** Pictures per second without {@code ?fps=N}. */
    private static final double USUAL_RATE = 10;

    private static final int MOST_RATE = 20;
    private static final Pattern RATE = Pattern.compile("(?:.*&)?fps=([^&]*)(?:&.*)?");

    private final SceneCache scenes;
    private final CameraPictureCache cameras;
    private final Semaphore places = new Semaphore(MOST);

    CameraStreams(SceneCache scenes, CameraPictureCache cameras) {
        this.scenes = scenes;
        this.cameras = cameras;
    }

    /** Answers GET with a stream, HEAD with the headers only. */
    WebResponse begin(WebRequest request, String robot) throws RequestException {
        double rate = rate(request.query());
        boolean isWatched = !request.isHead();
        if (isWatched && !places.tryAcquire()) {
            return WebResponse.error(WebResponse.UNAVAILABLE, "all " + MOST + " streams are taken, expected later")
                    .with("Retry-After", "5");
        }
        Runnable ended = isWatched ? places::release : () -> {};
        return WebResponse.stream(
                "multipart/x-mixed-replace; boundary=" + CameraStream.BOUNDARY,
                new CameraStream(robot, rate, scenes, cameras, ended));
    }

    private static double rate(String query) throws RequestException {
        Optional<String> wanted =
                Optional.of(query).map(RATE::matcher).filter(Matcher::matches).map(m -> m.group(1));
        if (wanted.isEmpty()) {
            return USUAL_RATE;
        }
        String text = wanted.get();
        if (text.matches("[0-9]{1,2}") && Integer.parseInt(text) >= 1 && Integer.parseInt(text) <= MOST_RATE) {
            return Integer.parseInt(text);
        }
        throw new RequestException(
                WebResponse.BAD_REQUEST, "fps: expected a whole number of 1 to " + MOST_RATE + ", found " + text);
    }
}
