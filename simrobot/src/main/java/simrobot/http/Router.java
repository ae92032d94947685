package simrobot.http;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpHandler;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;

/** Answers requests by their path. */
final class Router implements HttpHandler {
    private static final Logger LOG = System.getLogger(Router.class.getName());
    private static final int MOST_NAMES = 20;
    private static final String CAMERA = "camera.jpg";
    private static final String STREAM = "camera.mjpg";

    private final WebSource source;
    private final SceneCache scenes;
    private final CameraPictureCache cameras;
    private final CameraStreams streams;
    private final Page page;

    Router(WebSource source, SceneCache scenes, CameraPictureCache cameras, CameraStreams streams, Page page) {
        this.source = source;
        this.scenes = scenes;
        this.cameras = cameras;
        this.streams = streams;
        this.page = page;
    }

    @Override
    public void handle(HttpExchange exchange) throws IOException {
        String path = Objects.requireNonNullElse(exchange.getRequestURI().getRawPath(), "");
        try {
            requireGetOrHead(exchange);
            List<String> parts = UrlPaths.parts(path);
            if (parts.size() == 3
                    && parts.get(0).equals("robots")
                    && parts.get(2).equals(STREAM)) {
                RobotSnapshot robot = withCamera(robot(scenes.now(), parts.get(1)));
                streams.begin(exchange, robot.name());
            } else {
                send(exchange, answer(parts, path));
            }
        } catch (RequestException refusal) {
            send(exchange, refusal.answer());
        } catch (IllegalStateException noAnswer) {
            send(exchange, WebResponse.error(WebResponse.UNAVAILABLE, noAnswer.getMessage()));
        } catch (IllegalArgumentException malformed) {
            send(exchange, WebResponse.error(WebResponse.BAD_REQUEST, "malformed path " + path));
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

    private WebResponse answer(List<String> parts, String path)
            throws IOException, InterruptedException, RequestException {
        SimulationSnapshot scene = scenes.now();
        if (parts.isEmpty()) {
            return WebResponse.html(page.of(scene, source));
        }
        if (parts.get(0).equals("robots") && parts.size() <= 3) {
            if (parts.size() == 1) {
                return WebResponse.json(StatusJson.all(scene, source));
            }
            RobotSnapshot robot = robot(scene, parts.get(1));
            if (parts.size() == 2) {
                return WebResponse.json(StatusJson.one(scene, robot, source));
            }
            if (parts.get(2).equals(CAMERA)) {
                return WebResponse.jpeg(cameras.shot(scene, withCamera(robot)).jpeg());
            }
        }
        throw new RequestException(
                WebResponse.NOT_FOUND,
                "nothing at " + path + ", expected /, /robots, /robots/NAME, /robots/NAME/" + CAMERA
                        + " or /robots/NAME/" + STREAM);
    }

    private static RobotSnapshot robot(SimulationSnapshot scene, String name) throws RequestException {
        return scene.robot(name)
                .orElseThrow(() -> new RequestException(
                        WebResponse.NOT_FOUND,
                        "no robot " + name + ", expected one of "
                                + scene.robots().stream()
                                        .map(RobotSnapshot::name)
                                        .limit(MOST_NAMES)
                                        .collect(Collectors.joining(", "))));
    }

    private static RobotSnapshot withCamera(RobotSnapshot robot) throws RequestException {
        if (!robot.simulated()) {
            throw new RequestException(
                    WebResponse.NOT_FOUND, robot.name() + " is a real robot, its camera is not served here");
        }
        return robot;
    }

    private static void send(HttpExchange exchange, WebResponse answer) throws IOException {
        boolean headersOnly = exchange.getRequestMethod().equals("HEAD");
        Headers headers = exchange.getResponseHeaders();
        headers.set("Content-Type", answer.type());
        headers.set("Cache-Control", "no-store");
        headers.set("X-Content-Type-Options", "nosniff");
        headers.set("Content-Security-Policy", Page.POLICY);
        try (exchange) {
            if (headersOnly) {
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
