package simrobot.ros;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simgsm.web.AccessKeys;
import simgsm.web.JsonReader;
import simgsm.web.RequestException;
import simgsm.web.WebSocket;
import simgsm.web.WebSocketListener;

/** One client's socket: performs its messages and answers each one that is refused. Owned by the sockets' thread. */
final class RosSession implements WebSocketListener {
    private static final Logger LOG = System.getLogger(RosSession.class.getName());

    static final int MOST_OCTETS = 8 * 1024;

    private static final int MOST_WISHES = 100;
    private static final String ERROR = "error";
    private static final RosRequest UNREADABLE = new RosRequest(Map.of());

    /** The requirements of one {@code subscribe}. */
    private record Wish(RosGeneration generation, long periodMillis) {}

    /**
     * A topic's subscription; a client may subscribe more than once, with different ids, and gets each message once.
     */
    private static final class Subscription {
        private final RosTopic.Source source;
        private final Map<Object, Wish> wishes = new LinkedHashMap<>();
        private long sentNanos;
        private boolean isSent;

        Subscription(RosTopic.Source source) {
            this.source = source;
        }

        /** The generation of the newest wish. */
        RosGeneration generation() {
            return List.copyOf(wishes.values()).get(wishes.size() - 1).generation;
        }

        boolean isDue(long nanos) {
            long millis =
                    wishes.values().stream().mapToLong(Wish::periodMillis).min().orElseThrow();
            // a tick may be early
            return !isSent || nanos - sentNanos >= millis * 1_000_000 - RosServer.TICK_NANOS / 2;
        }
    }

    private final WebSocket socket;
    private final RosServer server;
    private final RosServices services;
    private final Map<String, Subscription> subscriptions = new HashMap<>();
    /** The robots driven by the topics. */
    private final Map<String, String> advertised = new HashMap<>();

    private Optional<String> operator = Optional.empty();
    private boolean isRefusalLogged;

    RosSession(WebSocket socket, RosServer server) {
        this.socket = socket;
        this.server = server;
        services = new RosServices(this, server);
    }

    @Override
    public void text(String text) {
        RosRequest request = UNREADABLE;
        try {
            request = new RosRequest(JsonReader.object(text));
            perform(request);
        } catch (IllegalArgumentException refusal) {
            refuse(request, refusal.getMessage());
        }
    }

    @Override
    public void binary(byte[] octets) {
        refuse(UNREADABLE, "expected JSON in a text message");
    }

    @Override
    public void closed() {
        server.ended(this);
    }

    void send(String text) {
        socket.send(text);
    }

    /** Tells the client, and once the log, because pages seldom show status messages. */
    void refuse(RosRequest request, String reason) {
        String shown = RequestException.shortened(reason);
        if (!isRefusalLogged) {
            isRefusalLogged = true;
            LOG.log(Level.WARNING, "a ROS client at {0}: {1}", socket.peer().getHostAddress(), shown);
        }
        send(request.status(ERROR, shown));
    }

    private void perform(RosRequest request) {
        switch (request.string("op")) {
            case "subscribe" -> subscribe(request);
            case "unsubscribe" -> unsubscribe(request);
            case "advertise" -> advertise(request);
            case "unadvertise" -> {
                String robot = advertised.remove(request.name("topic"));
                require(robot != null, request, "is not advertised");
                server.release(this, robot);
            }
            case "publish" -> publish(request);
            case "call_service" -> services.call(request);
            case "auth" -> authenticate(request);
            default ->
                throw new IllegalArgumentException("unknown op " + request.string("op")
                        + ", expected subscribe, unsubscribe, advertise, unadvertise, publish, call_service or auth");
        }
    }

    private static void require(boolean isSo, RosRequest request, String otherwise) {
        if (!isSo) {
            throw new IllegalArgumentException("topic " + request.name("topic") + " " + otherwise);
        }
    }

    // ---- messages to the client ----------------------------------------------------------------------------------

    private void subscribe(RosRequest request) {
        RosTopic.Source source = source(request);
        require(!source.topic().isReceived(), request, "is published by clients, nothing is sent");
        RosGeneration generation = request.optional("type")
                .map(type -> generation(request, source, type))
                .orElse(RosGeneration.ROS_1);
        long millis = Math.max(source.topic().periodMillis(), request.millis("throttle_rate"));
        if (subscriptions.values().stream().mapToInt(each -> each.wishes.size()).sum() == MOST_WISHES) {
            throw new IllegalArgumentException("over " + MOST_WISHES + " subscriptions");
        }
        Subscription subscription =
                subscriptions.computeIfAbsent(request.name("topic"), name -> new Subscription(source));
        subscription.wishes.remove(request.id());
        subscription.wishes.put(request.id(), new Wish(generation, millis));
        server.subscribed();
    }

    private void unsubscribe(RosRequest request) {
        String name = request.name("topic");
        Subscription subscription = subscriptions.get(name);
        require(subscription != null, request, "is not subscribed");
        if (request.id() == null) {
            subscription.wishes.clear();
        } else if (!subscription.wishes.containsKey(request.id())) {
            throw new IllegalArgumentException("topic " + name + " is not subscribed by this id");
        }
        subscription.wishes.remove(request.id());
        if (subscription.wishes.isEmpty()) {
            subscriptions.remove(name);
        }
    }

    private RosTopic.Source source(RosRequest request) {
        RosTopic.Source source = server.topics().get(request.name("topic"));
        require(source != null, request, "does not exist, expected one that the service /rosapi/topics names");
        return source;
    }

    private static RosGeneration generation(RosRequest request, RosTopic.Source source, String type) {
        String expected = source.topic().type(RosGeneration.ROS_1);
        Optional<RosGeneration> generation = source.topic().generation(type);
        require(generation.isPresent(), request, "has the type " + expected + ", not " + type);
        return generation.get();
    }

    boolean hasSubscriptions() {
        return !subscriptions.isEmpty();
    }

    /** The messages due now, which count as sent; none if the client has not read the last ones. */
    List<RosServer.Wanted> due(long nanos) {
        List<RosServer.Wanted> due = new ArrayList<>();
        if (!socket.hasOutput()) {
            subscriptions.forEach((name, subscription) -> {
                if (subscription.isDue(nanos)) {
                    subscription.isSent = true;
                    subscription.sentNanos = nanos;
                    due.add(new RosServer.Wanted(name, subscription.source, subscription.generation()));
                }
            });
        }
        return due;
    }

    /** Sends the topic's message, unless its subscription has ended. */
    void send(RosServer.Wanted wanted, String text) {
        if (subscriptions.containsKey(wanted.name())) {
            send(text);
        }
    }

    // ---- commands of the client ----------------------------------------------------------------------------------

    private void advertise(RosRequest request) {
        RosTopic.Source source = source(request);
        require(source.topic().isReceived(), request, "is published by the robot only");
        generation(request, source, request.string("type"));
        advertised.put(request.name("topic"), source.robot());
    }

    private void publish(RosRequest request) {
        RosTopic.Source source = source(request);
        require(source.topic().isReceived(), request, "is published by the robot only");
        require(
                advertised.containsKey(request.name("topic")),
                request,
                "is not advertised, expected op advertise first");
        Twist velocity = Twist.of(request.fields().get("msg"));
        requirePower();
        server.drive(this, source.robot(), velocity, reason -> refuse(request, reason));
    }

    /**
     * Requires the right to move a robot: a key, or without keys a program or page of this machine.
     *
     * @return its operator's name
     */
    String requirePower() {
        if (operator.isPresent()) {
            return operator.get();
        }
        if (server.source().keys().isPresent()) {
            throw new IllegalArgumentException("only with a key, expected {\"op\":\"auth\",\"key\":...} first");
        }
        if (!socket.peer().isLoopbackAddress() || !socket.isLocalPage()) {
            throw new IllegalArgumentException(
                    "without --http-keys only programs of the simulator's machine, and pages from"
                            + " http://localhost there, may move a robot");
        }
        return "ros";
    }

    private void authenticate(RosRequest request) {
        AccessKeys keys = server.source()
                .keys()
                .orElseThrow(() ->
                        new IllegalArgumentException("there are no keys, expected SimRobot with --http-keys FILE"));
        try {
            String name = keys.operator(request.string("key"), socket.peer(), System.nanoTime());
            operator = Optional.of(name);
            send(request.status("info", "authenticated as " + name));
        } catch (RequestException wrong) {
            refuse(request, wrong.getMessage());
        }
    }
}
