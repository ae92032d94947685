package simrobot.http;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import simgsm.timer.BoundedMap;
import simgsm.web.AccessKeys;
import simgsm.web.JsonBody;
import simgsm.web.JsonText;
import simgsm.web.RequestException;
import simgsm.web.UrlPaths;
import simgsm.web.WebResponse;
import simrobot.simulation.RobotSnapshot;
import vericommand.OrderReport;
import vericommand.Reply;

/**
 * Orders of programs: {@code POST /robots/NAME/orders} places one, {@code GET /robots/NAME/orders/ID} reports its
 * progress.
 */
final class OrderPages {
    /** Number of stored orders, the newest. */
    static final int MOST_ORDERS = 10_000;

    private static final int ACCEPTED = 202;
    /** Over ten times the longest order. */
    private static final int MOST_OCTETS = 1024;

    private static final String IDEMPOTENCY_KEY = "Idempotency-Key";

    private static final class HttpOrder {
        final long id;
        final String robot;
        final String operator;
        final String keys;
        volatile OrderReport report;

        HttpOrder(long id, String robot, String operator, String keys) {
            this.id = id;
            this.robot = robot;
            this.operator = operator;
            this.keys = keys;
        }
    }

    private final AccessKeys keys;
    private final WebSource source;
    private final Map<String, OperatorRequests> requests = new ConcurrentHashMap<>();
    private final Map<String, HttpOrder> orders = new BoundedMap<>(MOST_ORDERS);
    private long newestId;

    OrderPages(AccessKeys keys, WebSource source) {
        this.keys = keys;
        this.source = source;
    }

    AccessKeys keys() {
        return keys;
    }

    /** @throws RequestException with status 429 if an operator sends too many requests */
    void requireRate(String operator) throws RequestException {
        requests(operator).requireRate(System.nanoTime());
    }

    private OperatorRequests requests(String operator) {
        return requests.computeIfAbsent(operator, name -> new OperatorRequests());
    }

    /** Places the order of a request. */
    WebResponse place(HttpExchange exchange, String operator, RobotSnapshot robot)
            throws IOException, InterruptedException, RequestException {
        Object text = JsonBody.read(exchange, MOST_OCTETS).get("keys");
        if (!(text instanceof String order)) {
            throw invalid("expected a field keys with the order as a string, such as \"** #**20 **\"");
        }
        String key = exchange.getRequestHeaders().getFirst(IDEMPOTENCY_KEY);
        if (key != null && !key.matches("[ -~]{1,255}")) {
            throw invalid(IDEMPOTENCY_KEY + ": expected 1 to 255 ASCII characters");
        }
        OperatorRequests.Request act = () -> place(robot, operator, order);
        UUID hash = UUID.nameUUIDFromBytes((robot.name() + " " + order).getBytes(StandardCharsets.UTF_8));
        PlacedOrder placed = key == null ? act.perform() : requests(operator).once(key, hash, act, System.nanoTime());
        if (!placed.location().isEmpty()) {
            exchange.getResponseHeaders().set("Location", placed.location());
        }
        return placed.answer();
    }

    private static RequestException invalid(String text) {
        return new RequestException(WebResponse.UNPROCESSABLE, text);
    }

    private PlacedOrder place(RobotSnapshot robot, String operator, String keys)
            throws InterruptedException, RequestException {
        HttpOrder order = new HttpOrder(nextId(), robot.name(), operator, keys);
        if (!source.order(robot.name(), operator, keys, report -> order.report = report)) {
            throw new RequestException(WebResponse.NOT_FOUND, "no robot " + robot.name() + " any more");
        }
        OrderReport report = order.report;
        if (report.verdict().filter("invalid"::equals).isPresent()) {
            String text = report.reply().map(Reply::text).orElseThrow();
            return new PlacedOrder(WebResponse.error(WebResponse.UNPROCESSABLE, text), "");
        }
        keep(order);
        byte[] body = json(order, robot).getBytes(StandardCharsets.UTF_8);
        return new PlacedOrder(
                new WebResponse(ACCEPTED, "application/json", body),
                "/robots/" + UrlPaths.encoded(order.robot) + "/orders/" + order.id);
    }

    private synchronized long nextId() {
        return ++newestId;
    }

    private synchronized void keep(HttpOrder order) {
        orders.put(Long.toString(order.id), order);
    }

    /** An order's current state. */
    WebResponse newest(RobotSnapshot robot, String id) throws RequestException {
        HttpOrder order;
        synchronized (this) {
            order = orders.get(id);
        }
        if (order == null || !order.robot.equals(robot.name())) {
            throw new RequestException(
                    WebResponse.NOT_FOUND,
                    "no order " + RequestException.shortened(id) + " of " + robot.name()
                            + ", expected one of the newest " + MOST_ORDERS);
        }
        return WebResponse.json(json(order, robot));
    }

    /** The pose at the order's end, until then the current one. */
    private static String json(HttpOrder order, RobotSnapshot robot) {
        OrderReport report = order.report;
        boolean isEnded = report.state() == OrderReport.State.ENDED;
        JsonText json = new JsonText().open('{').name("id").value(order.id);
        json.name("keys").value(order.keys);
        json.name("from").value(order.operator);
        json.name("verdict").value(report.verdict().orElse(null));
        json.name("state").value(report.state().word());
        if (report.reply().isPresent()) {
            Reply reply = report.reply().get();
            json.name("tone").value(reply.tone().number()).name("text").value(reply.text());
        } else {
            json.name("tone").value(null).name("text").value(null);
        }
        json.name("pose").open('{');
        json.name("x").value(isEnded ? report.pose().xMeters() : robot.xMeters(), 4);
        json.name("y").value(isEnded ? report.pose().yMeters() : robot.yMeters(), 4);
        double heading = isEnded ? Math.toRadians(report.pose().headingDegrees()) : robot.headingRadians();
        json.name("heading").value(StatusJson.degrees(heading), 2);
        return json.close('}').close('}').toString();
    }
}
