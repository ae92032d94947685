package simrobot.p2os;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayDeque;
import java.util.Deque;
import simrobot.robot.SimulatedRobot;
import vericommand.Pose;

/**
 * A robot's port. It stays open when a client leaves. Further clients wait for a moment, in case the first is just
 * leaving; then they are sent away, unless the first has fallen silent: then the next takes its place.
 */
final class P2osAcceptor {
    private static final Logger LOG = System.getLogger(P2osAcceptor.class.getName());

    /** How long a further client waits: a little longer than the first may be silent. */
    private static final long WAIT_NANOS = 2_500_000_000L;

    private static final int MOST_SAID = 4096;

    private static final int MOST_WAITING = 16;

    private record Waiting(SocketChannel channel, long sinceNanos) {}

    private final P2osServer server;
    private final SimulatedRobot robot;
    private final Pose start;
    private final ServerSocketChannel listening;
    private final SelectionKey key;
    private Client client;
    private final Deque<Waiting> waiting = new ArrayDeque<>();

    P2osAcceptor(P2osServer server, SimulatedRobot robot, InetSocketAddress address) throws IOException {
        this.server = server;
        this.robot = robot;
        start = robot.pose();
        listening = ServerSocketChannel.open();
        try {
            listening.setOption(StandardSocketOptions.SO_REUSEADDR, true);
            listening.bind(address);
            listening.configureBlocking(false);
            key = listening.register(server.selector(), SelectionKey.OP_ACCEPT, this);
        } catch (IOException e) {
            listening.close();
            throw new IOException("P2OS port " + address.getPort() + ": " + e.getMessage(), e);
        }
    }

    SimulatedRobot robot() {
        return robot;
    }

    int port() {
        return listening.socket().getLocalPort();
    }

    /** Someone knocks. */
    void accept() {
        try {
            for (SocketChannel come = listening.accept(); come != null; come = listening.accept()) {
                receive(come);
            }
        } catch (IOException e) {
            // out of file descriptors, say: nobody is heard until the next look round
            LOG.log(Level.WARNING, "P2OS port " + port() + ": " + e.getMessage());
            key.interestOps(0);
        }
    }

    private void receive(SocketChannel come) {
        if (client != null) {
            client.notice();
        }
        if (client == null) {
            seat(come);
        } else if (waiting.size() < MOST_WAITING) {
            waiting.add(new Waiting(come, System.nanoTime()));
        } else {
            dismiss(come);
        }
    }

    /** Now and then: who waits comes in or is sent away. */
    void lookRound() {
        if (key.isValid()) {
            key.interestOps(SelectionKey.OP_ACCEPT);
        }
        long now = System.nanoTime();
        if (!waiting.isEmpty() && client != null && client.isSilent(now)) {
            LOG.log(Level.INFO, robot.name() + ": a silent P2OS client makes room");
            client.drop();
        }
        while (!waiting.isEmpty() && now - waiting.peek().sinceNanos() > WAIT_NANOS) {
            dismiss(waiting.remove().channel());
        }
    }

    private void seat(SocketChannel come) {
        try {
            Client seated = new Client(server, this, come);
            client = seated;
            LOG.log(Level.INFO, robot.name() + ": a P2OS client has come");
            seated.begin(robot, start);
        } catch (IOException e) {
            dismiss(come);
        }
    }

    /** What it has said is read first: else it would hear of an error instead of an end. */
    private void dismiss(SocketChannel unwanted) {
        try (unwanted) {
            unwanted.configureBlocking(false);
            ByteBuffer said = ByteBuffer.allocate(MOST_SAID);
            unwanted.read(said);
            unwanted.shutdownOutput();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing failed", e);
        }
    }

    /** The client has gone. */
    void left(Client gone) {
        if (client == gone) {
            client = null;
            LOG.log(Level.INFO, robot.name() + ": the P2OS client has gone");
            while (client == null && !waiting.isEmpty()) {
                seat(waiting.remove().channel());
            }
        }
    }

    void close() {
        waiting.forEach(one -> dismiss(one.channel()));
        waiting.clear();
        if (client != null) {
            client.drop();
        }
        try {
            listening.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing failed", e);
        }
    }
}
