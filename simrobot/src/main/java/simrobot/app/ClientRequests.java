package simrobot.app;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import simrobot.control.SimRobot;
import simrobot.p2os.SimulatorRequests;
import simrobot.world.World;

/** Loads the worlds that Pioneer programs ask for, on a thread of its own, and passes their texts to the robot's listeners. */
final class ClientRequests implements SimulatorRequests {
    private static final Logger LOG = System.getLogger(ClientRequests.class.getName());

    private final SimRobot simRobot;
    private volatile Consumer<Path> loader = this::load;

    ClientRequests(SimRobot simRobot) {
        this.simRobot = simRobot;
    }

    /** Sets what loads a world file in place of this, such as a window that shows its name. */
    void setLoader(Consumer<Path> newLoader) {
        loader = newLoader;
    }

    @Override
    public void loadWorld(String robot, String file) {
        LOG.log(Level.INFO, robot + ": its P2OS client asks for the world " + file);
        Thread reading = new Thread(() -> find(file), "world for a P2OS client");
        reading.setDaemon(true);
        reading.start();
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
                    owned.load(world);
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
