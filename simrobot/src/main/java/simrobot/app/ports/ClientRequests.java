package simrobot.app.ports;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import simgsm.thread.DaemonThread;
import simrobot.app.WorldFile;
import simrobot.control.SimRobot;
import simrobot.p2os.SimulatorRequests;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.World;

/**
 * Loads the worlds that Pioneer programs request, and passes their texts to the robot's listeners. One thread reads the
 * files and keeps only the newest waiting request. Requests are refused while a robot executes an order, because a new
 * world ends all orders.
 */
public final class ClientRequests implements SimulatorRequests {
    private static final Logger LOG = System.getLogger(ClientRequests.class.getName());

    private static final int KEPT_REQUESTS = 1;
    private static final int IDLE_SECONDS = 10;

    private final SimRobot simRobot;
    private final Executor worker;
    private volatile Consumer<Path> loader = this::load;

    ClientRequests(SimRobot simRobot) {
        this.simRobot = simRobot;
        ThreadPoolExecutor newest = new ThreadPoolExecutor(
                1,
                1,
                IDLE_SECONDS,
                TimeUnit.SECONDS,
                new ArrayBlockingQueue<>(KEPT_REQUESTS),
                reading -> DaemonThread.of("world for a P2OS client", reading::run),
                new ThreadPoolExecutor.DiscardOldestPolicy());
        newest.allowCoreThreadTimeOut(true);
        worker = newest;
    }

    /** True if no robot executes an order, so that a client may change the world; on the simulation's thread. */
    public static boolean mayLoad(Simulation simulation) {
        boolean free = simulation.robots().stream().noneMatch(SimulatedRobot::isUnderOrder);
        if (!free) {
            LOG.log(Level.WARNING, "a P2OS client's world is not loaded: a robot executes an order");
        }
        return free;
    }

    /** Replaces the loader of world files, for a window that shows the file's name. */
    void setLoader(Consumer<Path> newLoader) {
        loader = newLoader;
    }

    @Override
    public void loadWorld(String robot, String file) {
        LOG.log(Level.INFO, robot + ": its P2OS client asks for the world " + file);
        if (mayLoad(simRobot.simulation().owned())) {
            worker.execute(() -> find(file));
        }
    }

    private void find(String file) {
        try {
            loader.accept(WorldFile.find(Optional.of(Path.of(file))));
        } catch (InvalidPathException noPath) {
            LOG.log(Level.WARNING, "expected a world file, found " + file);
        }
    }

    private void load(Path file) {
        try {
            World world = WorldFile.read(Optional.of(file));
            simRobot.simulation().withSimulation(owned -> {
                try {
                    if (mayLoad(owned)) {
                        owned.load(world);
                    }
                } catch (IllegalArgumentException tooSmall) {
                    LOG.log(Level.WARNING, "world " + file + " not loaded: " + tooSmall.getMessage());
                }
            });
        } catch (IOException unreadable) {
            LOG.log(Level.WARNING, "world " + file + " not loaded: " + unreadable.getMessage());
        }
    }

    @Override
    public void show(String robot, String text) {
        simRobot.robot(robot).ifPresent(named -> named.clientMessage(text));
    }
}
