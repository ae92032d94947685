package simrobot.app.ports;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simgsm.speech.AudioOutput;
import simrobot.control.SimRobot;
import simrobot.robot.SimulatedRobot;
import simrobot.simulation.Simulation;
import simrobot.world.World;
import vericommand.Instruction;
import vericommand.VeriCommandSettings;

/** What Pioneer programs ask of the simulator neither piles up nor ends orders by telephone. */
@Timeout(30)
class ClientRequestsTest {
    private final Simulation simulation = new Simulation(World.bare(), 1);
    private final SimulatedRobot robot = simulation.addRobot("robot");
    private final BlockingQueue<String> loaded = new LinkedBlockingQueue<>();
    private final CountDownLatch mayRead = new CountDownLatch(1);
    private SimRobot simRobot;
    private ClientRequests requests;

    @BeforeEach
    void aPausedSimulation() {
        simRobot = new SimRobot(simulation, new InetSocketAddress(0), VeriCommandSettings.DEFAULT, AudioOutput.SILENT);
        simRobot.simulation().setPaused(true);
        simRobot.simulation().start();
        requests = new ClientRequests(simRobot);
        requests.setLoader(this::read);
    }

    @AfterEach
    void close() {
        simRobot.close();
    }

    private void read(Path file) {
        loaded.add(file.toString());
        try {
            mayRead.await();
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }

    private void ask(String file) throws Exception {
        simRobot.onSimulation(() -> {
            requests.loadWorld("robot", file);
            return file;
        });
    }

    @Test
    void whileAFileIsReadOnlyTheNewestRequestIsKept() throws Exception {
        ask("first");
        assertEquals("first", loaded.poll(20, TimeUnit.SECONDS));
        for (int i = 0; i < 50; i++) {
            ask("between");
        }
        ask("last");
        assertTrue(loaded.isEmpty(), "one is read at a time, found " + loaded);
        mayRead.countDown();
        assertEquals("last", loaded.poll(20, TimeUnit.SECONDS));
    }

    @Test
    void noWorldIsLoadedWhileARobotIsUnderOrder() throws Exception {
        mayRead.countDown();
        simRobot.onSimulation(() -> {
            robot.start(new Instruction.Forward(100), outcome -> {});
            return robot.isUnderOrder();
        });
        ask("refused");
        simRobot.onSimulation(() -> {
            robot.brakeAtOnce();
            return robot.isUnderOrder();
        });
        ask("free");
        assertEquals("free", loaded.poll(20, TimeUnit.SECONDS));
        assertEquals(List.of(), List.copyOf(loaded));
    }
}
