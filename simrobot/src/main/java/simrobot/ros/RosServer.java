package simrobot.ros;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.LongConsumer;
import java.util.stream.Collectors;
import simgsm.net.SelectorLoop;
import simgsm.thread.DaemonThread;
import simgsm.web.JsonText;
import simgsm.web.RequestException;
import simgsm.web.WebPages;
import simgsm.web.WebPort;
import simgsm.web.WebResponse;
import simgsm.web.WebSocket;
import simgsm.web.WebSocketPath;
import simrobot.camera.CameraPictureCache;
import simrobot.simulation.SimulationSnapshot;

/** Serves ROS programs on a WebSocket at {@code /}, pages of every origin included. */
public final class RosServer implements AutoCloseable {
    static final long TICK_NANOS = TimeUnit.MILLISECONDS.toNanos(50);
    static final int MOST_SOCKETS = 64;

    private static final Logger LOG = System.getLogger(RosServer.class.getName());
    private static final String PATH = "/";
    /** Try again later (IANA's registry of close codes). */
    private static final int TRY_AGAIN_LATER = 1013;

    /** A message that is due to a client. */
    record Wanted(String name, RosTopic.Source source, RosGeneration generation) {}

    /** Answers every request but the handshake of the WebSocket with 404. */
    private static final class NoPages extends WebPages {
        NoPages() {
            super("default-src 'none'");
        }

        @Override
        protected Optional<WebResponse> answer(HttpExchange exchange, List<String> parts, String path)
                throws RequestException {
            throw RequestException.notFound(path, "a WebSocket at " + PATH);
        }
    }

    private final RosSource source;
    private final SelectorLoop loop = new SelectorLoop("rosbridge");
    private final WebPort port;
    private final Set<RosSession> sessions = new LinkedHashSet<>();
    private final VelocityCommands velocities = new VelocityCommands();
    private final CameraPictureCache cameras = new CameraPictureCache();
    private final ExecutorService worker = DaemonThread.executor("rosbridge messages");
    private boolean isTicking;
    private boolean isSampling;

    /**
     * Opens the port; {@link #start} begins serving clients.
     *
     * @throws IOException naming address and port
     */
    public RosServer(InetSocketAddress address, RosSource source) throws IOException {
        this.source = source;
        WebSocketPath path = new WebSocketPath(PATH, "", true, RosSession.MOST_OCTETS, this::opened);
        port = new WebPort(loop::listen, address, new NoPages(), List.of(path), true);
    }

    public int port() {
        return port.port();
    }

    /** @param onFailure called if the sockets' thread has ended with an error */
    public void start(Consumer<Throwable> onFailure) {
        source.simulation()
                .withSimulation(owned -> owned.addStepListener(simulated -> velocities.tick(System.nanoTime())));
        loop.start(SelectorLoop.Core.NONE, onFailure);
        port.start();
        LOG.log(Level.INFO, "rosbridge on port {0}", Integer.toString(port()));
    }

    @Override
    public void close() {
        port.close();
        loop.close();
        worker.shutdownNow();
    }

    // ---- the sockets' thread -------------------------------------------------------------------------------------

    private RosSession opened(WebSocket socket) {
        RosSession session = new RosSession(socket, this);
        if (sessions.size() < MOST_SOCKETS) {
            sessions.add(session);
        } else {
            loop.post(() -> socket.close(TRY_AGAIN_LATER, MOST_SOCKETS + " programs are connected, expected fewer"));
        }
        return session;
    }

    void ended(RosSession session) {
        sessions.remove(session);
        release(session);
    }

    RosSource source() {
        return source;
    }

    Map<String, RosTopic.Source> topics() {
        return RosTopic.all(source.robots());
    }

    /** @param refused receives the reason if the robot refuses the velocity */
    void drive(RosSession client, String name, Twist velocity, Consumer<String> refused) {
        long nanos = System.nanoTime();
        source.simulation()
                .withSimulation(owned -> owned.robot(name)
                        .map(robot -> velocities.drive(robot, client, velocity, nanos))
                        .orElseGet(() -> Optional.of("no robot " + name + " any more"))
                        .ifPresent(reason -> loop.post(() -> refused.accept(reason))));
    }

    /** Brakes the robots driven by the client. */
    void release(RosSession client) {
        source.simulation().withSimulation(owned -> velocities.release(client));
    }

    /** Brakes this robot if the client drives it. */
    void release(RosSession client, String name) {
        source.simulation()
                .withSimulation(owned -> owned.robot(name).ifPresent(robot -> velocities.release(client, robot)));
    }

    void order(String robot, String operator, String keys, BiConsumer<Integer, String> ended) {
        source.order(robot, operator, keys, (tone, text) -> loop.post(() -> ended.accept(tone, text)));
    }

    void atSimulatedTime(LongConsumer told) {
        source.simulation().withSimulation(owned -> {
            long nanos = owned.timeNanos();
            loop.post(() -> told.accept(nanos));
        });
    }

    // ---- messages ------------------------------------------------------------------------------------------------

    /** Starts the making of messages; called when a client has subscribed. */
    void subscribed() {
        if (!isTicking) {
            isTicking = true;
            loop.after(1, this::tick);
        }
    }

    private void tick() {
        isTicking = sessions.stream().anyMatch(RosSession::hasSubscriptions);
        if (isTicking) {
            loop.after(TICK_NANOS, this::tick);
        }
        if (isTicking && !isSampling) {
            sample(System.nanoTime());
        }
    }

    private void sample(long nanos) {
        Map<RosSession, List<Wanted>> due = new LinkedHashMap<>();
        sessions.forEach(session -> due.put(session, session.due(nanos)));
        due.values().removeIf(List::isEmpty);
        if (!due.isEmpty()) {
            isSampling = true;
            Set<String> ranged = due.values().stream()
                    .flatMap(List::stream)
                    .map(Wanted::source)
                    .filter(each -> each.topic().needsRanges())
                    .map(RosTopic.Source::robot)
                    .collect(Collectors.toSet());
            source.simulation().withSimulation(owned -> {
                try {
                    SimulationSnapshot scene = owned.snapshotWithRanges(ranged);
                    worker.execute(() -> send(texts(due, scene), due));
                } catch (RuntimeException fault) {
                    loop.post(() -> isSampling = false);
                    if (!worker.isShutdown()) {
                        throw fault;
                    }
                }
            });
        }
    }

    private void send(Map<Wanted, String> texts, Map<RosSession, List<Wanted>> due) {
        loop.post(() -> {
            isSampling = false;
            due.forEach((session, all) ->
                    all.stream().filter(texts::containsKey).forEach(wanted -> session.send(wanted, texts.get(wanted))));
        });
    }

    /** Encodes each message once for all clients, without those of removed robots. */
    private Map<Wanted, String> texts(Map<RosSession, List<Wanted>> due, SimulationSnapshot scene) {
        Map<Wanted, String> texts = new HashMap<>();
        for (List<Wanted> all : due.values()) {
            for (Wanted wanted : all) {
                String robot = wanted.source().robot();
                if (!texts.containsKey(wanted)
                        && (robot.isEmpty() || scene.robot(robot).isPresent())) {
                    try {
                        texts.put(wanted, text(wanted, new RosMessages(wanted.generation(), scene, cameras)));
                    } catch (IOException | RuntimeException fault) {
                        LOG.log(Level.ERROR, "no message of " + wanted.name(), fault);
                    }
                }
            }
        }
        return texts;
    }

    private static String text(Wanted wanted, RosMessages moment) throws IOException {
        Object message = wanted.source().topic().message(moment, wanted.source().robot());
        return new JsonText()
                .any(RosMessages.fields("op topic msg", "publish", wanted.name(), message))
                .toString();
    }
}
