package simrobot.p2os;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import simgsm.net.SelectorLoop;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.SimulationThread;

/**
 * Serves P2OS clients over TCP, one port per robot. One thread owns the sockets; the sessions run on the simulation's
 * thread.
 */
public final class P2osServer implements AutoCloseable {
    private static final Logger LOG = System.getLogger(P2osServer.class.getName());

    /** A handshake, which changes nothing in the robot. */
    public static final byte[][] FIRST_REQUESTS = {
        P2osCommand.packet(P2osCommandNumber.PULSE),
        P2osCommand.packet(P2osCommandNumber.OPEN),
        P2osCommand.packet(P2osCommandNumber.CLOSE)
    };

    /** Period of the ports' client checks, and of the sessions' ticks while the simulation makes no steps. */
    private static final long TICK_NANOS = 50_000_000;

    private final SimulationThread simulation;
    private final InetAddress address;
    private final SelectorLoop loop = new SelectorLoop("p2os");
    private final List<P2osPort> ports = new CopyOnWriteArrayList<>();
    private final List<P2osSession> sessions = new CopyOnWriteArrayList<>();
    private final AtomicBoolean tickPosted = new AtomicBoolean();
    private final SimulatorRequests requests;

    /**
     * Creates a server without open ports.
     *
     * @param requests receives the clients' requests to the simulator
     */
    public P2osServer(SimulationThread simulation, InetAddress address, SimulatorRequests requests) {
        this.simulation = simulation;
        this.address = address;
        this.requests = requests;
    }

    /**
     * Opens a port for the robot; before the start, or on the simulation's thread.
     *
     * @param number 0 selects any free port
     * @return the port
     * @throws IOException if the port cannot be opened; the message names it
     */
    public int add(SimulatedRobot robot, int number) throws IOException {
        P2osPort port = new P2osPort(this, loop, robot, new InetSocketAddress(address, number));
        ports.add(port);
        return port.port();
    }

    SimulatorRequests requests() {
        return requests;
    }

    /** Closes the robot's port and disconnects its clients. */
    public void remove(SimulatedRobot robot) {
        post(() -> ports.removeIf(port -> {
            boolean isRemoved = port.robot() == robot;
            if (isRemoved) {
                port.close();
            }
            return isRemoved;
        }));
    }

    /**
     * Starts serving clients.
     *
     * @param onFailure called if the sockets' thread has ended with an error
     */
    public void start(Consumer<Throwable> onFailure) {
        simulation.withSimulation(owned -> owned.addStepListener(this::tickSessions));
        ports.forEach(port -> LOG.log(Level.INFO, "P2OS port of " + port.robot().name() + ": " + port.port()));
        loop.start(SelectorLoop.Core.NONE, onFailure);
        post(this::tick);
    }

    /** Ends all connections and closes the ports. */
    @Override
    public void close() {
        post(() -> {
            ports.forEach(P2osPort::close);
            loop.end();
        });
        loop.join();
    }

    SimulationThread simulation() {
        return simulation;
    }

    /** Queues a task for the sockets' thread. */
    void post(Runnable task) {
        loop.post(task);
    }

    void add(P2osSession session) {
        sessions.add(session);
    }

    void remove(P2osSession session) {
        sessions.remove(session);
    }

    // ---- the simulation's thread -----------------------------------------------------------------------------------

    private void tickSessions(long simulatedNanos) {
        if (!sessions.isEmpty()) {
            long nanos = System.nanoTime();
            sessions.forEach(session -> tick(session, simulatedNanos, nanos));
        }
    }

    /** An exception ends the session in which it occurs, not the simulation. */
    private static void tick(P2osSession session, long simulatedNanos, long nanos) {
        try {
            session.tick(simulatedNanos, nanos);
        } catch (RuntimeException fault) {
            LOG.log(Level.ERROR, "a P2OS session ends after an internal error", fault);
            session.abort();
        }
    }

    // ---- the sockets' thread ---------------------------------------------------------------------------------------

    private void tick() {
        loop.after(TICK_NANOS, this::tick);
        ports.forEach(port -> port.tick(System.nanoTime()));
        if (!sessions.isEmpty() && tickPosted.compareAndSet(false, true)) {
            simulation.withSimulation(owned -> {
                tickPosted.set(false);
                tickSessions(owned.timeNanos());
            });
        }
    }
}
