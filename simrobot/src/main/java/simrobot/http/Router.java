package simrobot.http;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import simgsm.web.RequestException;
import simgsm.web.WebPages;
import simgsm.web.WebResponse;
import simrobot.camera.CameraPictureCache;
import simrobot.drawing.Viewport;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;

/** Answers requests by their path. */
final class Router extends WebPages {
    private static final int MOST_NAMES = 20;
    private static final String CAMERA = "camera.jpg";
    private static final String MAP = "map.svg";
    private static final String ORDERS = "orders";
    private static final String STREAM = "camera.mjpg";

    private final WebSource source;
    private final SceneCache scenes;
    private final CameraPictureCache cameras;
    private final CameraStreams streams;
    private final Page page;
    /** Empty on a read-only port. */
    private final Optional<OrderPages> orders;

    Router(
            WebSource source,
            SceneCache scenes,
            CameraPictureCache cameras,
            CameraStreams streams,
            Page page,
            Optional<OrderPages> orders) {
        super(Page.POLICY);
        this.source = source;
        this.scenes = scenes;
        this.cameras = cameras;
        this.streams = streams;
        this.page = page;
        this.orders = orders;
    }

    private boolean isOfOrders(List<String> parts) {
        return orders.isPresent()
                && (parts.size() == 3 || parts.size() == 4)
                && parts.get(0).equals("robots")
                && parts.get(2).equals(ORDERS);
    }

    @Override
    protected List<String> methods(List<String> parts) {
        return isOfOrders(parts) && parts.size() == 3 ? List.of("POST") : super.methods(parts);
    }

    @Override
    protected Optional<WebResponse> answer(HttpExchange exchange, List<String> parts, String path)
            throws IOException, InterruptedException, RequestException {
        boolean isStream = parts.size() == 3
                && parts.get(0).equals("robots")
                && parts.get(2).equals(STREAM);
        if (isOfOrders(parts)) {
            return Optional.of(answerOrder(exchange, orders.orElseThrow(), parts));
        }
        if (parts.isEmpty()) {
            return Optional.of(page.of(scenes.now(), source).answer(exchange));
        }
        if (!isStream) {
            return Optional.of(answer(parts, path));
        }
        RobotSnapshot robot = withCamera(robot(scenes.now(), parts.get(1)));
        streams.begin(exchange, robot.name());
        return Optional.empty();
    }

    /** Answers an order; checks the key before it uses the simulation. */
    private WebResponse answerOrder(HttpExchange exchange, OrderPages pages, List<String> parts)
            throws IOException, InterruptedException, RequestException {
        if (parts.size() == 4) {
            return pages.newest(robot(scenes.now(), parts.get(1)), parts.get(3));
        }
        String operator = operator(exchange, pages.keys());
        pages.requireRate(operator);
        return pages.place(exchange, operator, robot(scenes.now(), parts.get(1)));
    }

    private WebResponse answer(List<String> parts, String path)
            throws IOException, InterruptedException, RequestException {
        SimulationSnapshot scene = scenes.now();
        if (parts.equals(List.of(MAP))) {
            return WebResponse.text("image/svg+xml", page.map(scene, WorldMap.whole(scene.world())));
        }
        if (parts.get(0).equals("robots") && parts.size() <= 3) {
            if (parts.size() == 1) {
                return WebResponse.json(StatusJson.all(scene, source));
            }
            RobotSnapshot robot = robot(scene, parts.get(1));
            if (parts.size() == 2) {
                return WebResponse.json(StatusJson.one(scene, robot, source));
            }
            if (parts.get(2).equals(MAP)) {
                Viewport room = WorldMap.room(scene.world(), robot.xMeters(), robot.yMeters());
                return WebResponse.text("image/svg+xml", page.map(scene, room));
            }
            if (parts.get(2).equals(CAMERA)) {
                return WebResponse.jpeg(cameras.shot(scene, withCamera(robot)).jpeg());
            }
        }
        throw RequestException.notFound(
                path,
                "/, /" + MAP + ", /robots, /robots/NAME, /robots/NAME/" + MAP + ", /robots/NAME/" + CAMERA
                        + " or /robots/NAME/" + STREAM
                        + (orders.isPresent() ? ", or an order at /robots/NAME/" + ORDERS + "/ID" : ""));
    }

    private static RobotSnapshot robot(SimulationSnapshot scene, String name) throws RequestException {
        return scene.robot(name)
                .orElseThrow(() -> new RequestException(
                        WebResponse.NOT_FOUND,
                        "no robot " + RequestException.shortened(name) + ", expected one of "
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
}
