package simrobot.p2os;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.SimulationThread;

/**
 * Serves P2OS clients over TCP, a port for each robot, one client at a time on each. One thread owns the sockets; what the
 * clients say is done on the simulation's thread.
 */
public final class P2osServer implements AutoCloseable {
    private static final Logger LOG = System.getLogger(P2osServer.class.getName());
    private static final int LAST_PORT = 0xFFFF;

    /** How often sessions are told the time while the simulation makes no steps, and doors look round. */
    private static final long TICK_MILLIS = 50;

    private final SimulationThread simulation;
    private final InetAddress address;
    private final Selector selector = Selector.open();
    private final Queue<Runnable> tasks = new ConcurrentLinkedQueue<>();
    private final List<P2osAcceptor> doors = new CopyOnWriteArrayList<>();
    private final List<P2osSession> sessions = new CopyOnWriteArrayList<>();
    private final AtomicBoolean tickPosted = new AtomicBoolean();
    private final Thread thread = new Thread(this::loop, "p2os");
    private int nextPort;
    private volatile boolean closed;

    /**
     * No port is open yet.
     *
     * @param firstPort the first robot's; the next has the next one. 0 takes any free ones
     */
    public P2osServer(SimulationThread simulation, InetAddress address, int firstPort) throws IOException {
        this.simulation = simulation;
        this.address = address;
        nextPort = firstPort;
        thread.setDaemon(true);
    }

    /**
     * Opens a port for the robot; before the start, or on the simulation's thread.
     *
     * @return the port
     * @throws IOException naming the port, when it cannot be had
     */
    public int add(SimulatedRobot robot) throws IOException {
        if (nextPort > LAST_PORT) {
            throw new IOException("no P2OS port left for " + robot.name() + " above " + LAST_PORT);
        }
        P2osAcceptor door = new P2osAcceptor(this, robot, new InetSocketAddress(address, nextPort));
        nextPort += nextPort == 0 ? 0 : 1;
        doors.add(door);
        return door.port();
    }

    /** Closes the robot's port and sends its client away. */
    public void remove(SimulatedRobot robot) {
        post(() -> doors.stream().filter(door -> door.robot() == robot).forEach(door -> {
            doors.remove(door);
            door.close();
        }));
    }

    /** Clients may come. */
    public void start() {
        simulation.withSimulation(owned -> owned.addStepListener(this::tick));
        doors.forEach(
                door -> LOG.log(Level.INFO, "P2OS clients of " + door.robot().name() + " on port " + door.port()));
        thread.start();
    }

    /** Ends all connections and gives the ports back. */
    @Override
    public void close() {
        closed = true;
        selector.wakeup();
        try {
            if (thread.isAlive()) {
                thread.join();
            } else {
                shut();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    // ---- for the doors and their clients -------------------------------------------------------------------------

    Selector selector() {
        return selector;
    }

    SimulationThread simulation() {
        return simulation;
    }

    /** Has something done on the thread of the sockets. */
    void post(Runnable task) {
        tasks.add(task);
        selector.wakeup();
    }

    void add(P2osSession session) {
        sessions.add(session);
    }

    void remove(P2osSession session) {
        sessions.remove(session);
    }

    // ---- the simulation's thread -----------------------------------------------------------------------------------

    private void tick(long simulatedNanos) {
        if (!sessions.isEmpty()) {
            long nanos = System.nanoTime();
            sessions.forEach(session -> tick(session, simulatedNanos, nanos));
        }
    }

    /** A fault in a session ends that session, not the simulation. */
    private void tick(P2osSession session, long simulatedNanos, long nanos) {
        try {
            session.tick(simulatedNanos, nanos);
        } catch (RuntimeException fault) {
            LOG.log(Level.ERROR, "a P2OS session failed and ends", fault);
            session.abort();
        }
    }

    // ---- the sockets' thread ---------------------------------------------------------------------------------------

    private void loop() {
        long ticked = System.nanoTime();
        while (!closed) {
            try {
                selector.select(TICK_MILLIS);
                List<SelectionKey> ready = List.copyOf(selector.selectedKeys());
                selector.selectedKeys().clear();
                ready.forEach(this::serve);
                for (Runnable task = tasks.poll(); task != null; task = tasks.poll()) {
                    task.run();
                }
                if (System.nanoTime() - ticked >= TICK_MILLIS * 1_000_000) {
                    ticked = System.nanoTime();
                    doors.forEach(P2osAcceptor::lookRound);
                    postTick();
                }
            } catch (IOException | RuntimeException fault) {
                LOG.log(Level.ERROR, "serving P2OS clients failed, and goes on", fault);
            }
        }
        shut();
    }

    private void serve(SelectionKey key) {
        if (key.attachment() instanceof P2osAcceptor door) {
            door.accept();
        } else if (key.attachment() instanceof Client client) {
            client.serve();
        }
    }

    private void postTick() {
        if (!sessions.isEmpty() && tickPosted.compareAndSet(false, true)) {
            simulation.withSimulation(owned -> {
                tickPosted.set(false);
                tick(owned.timeNanos());
            });
        }
    }

    private void shut() {
        doors.forEach(P2osAcceptor::close);
        try {
            selector.close();
        } catch (IOException e) {
            LOG.log(Level.DEBUG, "closing failed", e);
        }
    }
}
