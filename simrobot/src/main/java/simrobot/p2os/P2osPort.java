package simrobot.p2os;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.List;
import simgsm.net.Acceptor;
import simgsm.net.ConnectionLimits;
import simgsm.net.SelectorLoop;
import simrobot.robot.SimulatedRobot;
import vericommand.Pose;

/**
 * A robot's port, which serves one client at a time. Further clients wait up to 2.5 s and are then disconnected; the
 * first of them begins when the current one leaves or becomes silent.
 */
final class P2osPort {
    private static final Logger LOG = System.getLogger(P2osPort.class.getName());

    /** Maximum wait of a client: 0.5 s longer than the watchdog of the current client. */
    private static final long WAIT_NANOS = 2_500_000_000L;

    private static final int MOST_WAITING = 16;

    private final SimulatedRobot robot;
    private final Pose start;
    private final Acceptor acceptor;
    private final ArrayDeque<P2osClientConnection> waiting = new ArrayDeque<>();
    private P2osClientConnection client;

    P2osPort(P2osServer server, SelectorLoop loop, SimulatedRobot robot, InetSocketAddress address) throws IOException {
        this.robot = robot;
        start = robot.pose();
        acceptor = loop.listen(
                address,
                new ConnectionLimits(1 + MOST_WAITING, 1 + MOST_WAITING),
                endpoint -> new P2osClientConnection(endpoint, server, this));
    }

    SimulatedRobot robot() {
        return robot;
    }

    /** Returns the robot's pose at the opening of the port. */
    Pose start() {
        return start;
    }

    int port() {
        return acceptor.port();
    }

    void accepted(P2osClientConnection connection) {
        waiting.add(connection);
        if (client != null) {
            // detects a closed connection while nothing else is read from the client
            client.read();
        }
        beginNext();
    }

    private void beginNext() {
        if (client == null && !waiting.isEmpty()) {
            client = waiting.remove();
            client.begin();
        }
    }

    void closed(P2osClientConnection connection) {
        waiting.remove(connection);
        if (client == connection) {
            client = null;
            beginNext();
        }
    }

    /** Closes a silent client if another waits, and waiting clients after {@link #WAIT_NANOS}. */
    void tick(long nowNanos) {
        if (!waiting.isEmpty() && client != null && client.isSilent(nowNanos)) {
            LOG.log(Level.INFO, robot.name() + ": a silent P2OS client is replaced by the next");
            client.close();
        }
        while (!waiting.isEmpty() && nowNanos - waiting.peek().acceptedNanos() > WAIT_NANOS) {
            waiting.peek().dismiss();
        }
    }

    void close() {
        acceptor.close();
        List.copyOf(waiting).forEach(P2osClientConnection::dismiss);
        if (client != null) {
            client.close();
        }
    }
}
