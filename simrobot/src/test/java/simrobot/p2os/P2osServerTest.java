package simrobot.p2os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.util.List;
import java.util.Queue;
import java.util.Random;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import simrobot.simulation.Simulation;
import simrobot.simulation.SimulationThread;
import simrobot.world.World;

class P2osServerTest {
    private static final int HOSTILE_INPUTS = 1200;

    private SimulationThread simulation;
    private final Queue<Throwable> failures = new ConcurrentLinkedQueue<>();
    private P2osServer server;
    private int port;
    private int secondPort;

    @BeforeEach
    void twoRobots() throws IOException {
        Simulation floor = new Simulation(World.bare(), 1);
        simulation = new SimulationThread(floor);
        server = new P2osServer(simulation, InetAddress.getLoopbackAddress(), new SimulatorRequests() {});
        port = server.add(floor.addRobot("one"), 0);
        secondPort = server.add(floor.addRobot("two"), 0);
        simulation.start();
        server.start(fault -> failures.add(fault));
    }

    @AfterEach
    void end() {
        server.close();
        simulation.close();
        assertEquals(List.of(), List.copyOf(failures));
    }

    @Test
    void eachRobotHasItsOwnPort() throws IOException {
        try (SocketClient one = SocketClient.opened(port);
                SocketClient two = SocketClient.opened(secondPort)) {
            one.send(P2osCommand.packet(P2osCommandNumber.MOVE, 20));
            Sip sip = one.sip();
            for (int i = 0; i < 300 && sip.x() == 0; i++) {
                sip = one.sip();
            }
            assertTrue(sip.x() > 0);
            assertEquals(0, two.sip().x());
        }
    }

    @Test
    void thePortIsKeptWhenAClientLeavesAndServesTheNextAtOnce() throws IOException {
        for (int i = 0; i < 30; i++) {
            try (SocketClient client = SocketClient.opened(port)) {
                assertEquals(16, client.sip().sonars().size());
                if (i % 2 == 0) {
                    client.send(P2osCommand.packet(P2osCommandNumber.CLOSE));
                    if (i % 4 == 0) {
                        assertTrue(client.isHungUp());
                    }
                }
            }
        }
    }

    @Test
    void aSecondClientIsSentAwayWhileTheFirstSpeaks() throws Exception {
        try (SocketClient first = SocketClient.opened(port)) {
            Thread alive = new Thread(() -> {
                try {
                    while (!Thread.currentThread().isInterrupted()) {
                        first.sip();
                        first.send(P2osCommand.packet(P2osCommandNumber.PULSE));
                    }
                } catch (IOException | AssertionError ended) {
                    // the test is over
                }
            });
            alive.start();
            try (SocketClient second = new SocketClient(port)) {
                second.send(P2osCommand.packet(P2osCommandNumber.PULSE));
                assertNull(second.packet());
            }
            alive.interrupt();
            alive.join();
            assertNotNull(first.sip());
        }
    }

    @Test
    void whoComesWhileTheFirstIsLeavingIsLetIn() throws IOException {
        SocketClient first = SocketClient.opened(port);
        try (SocketClient second = new SocketClient(port)) {
            first.close();
            second.open();
            assertNotNull(second.sip());
        }
    }

    @Test
    void aPortThatIsTakenIsNamed() {
        IOException refused = assertThrows(IOException.class, () -> {
            P2osServer other = new P2osServer(simulation, InetAddress.getLoopbackAddress(), new SimulatorRequests() {});
            try (other) {
                other.add(anotherRobot(), port);
            }
        });
        assertTrue(refused.getMessage().contains(String.valueOf(port)), refused.getMessage());
    }

    private static simrobot.robot.SimulatedRobot anotherRobot() {
        return new Simulation(World.bare(), 1).addRobot("other");
    }

    @Test
    void aPortIsFreeAgainAtOnceAfterTheServerHasClosed() throws IOException {
        SocketClient client = SocketClient.opened(port);
        client.sip();
        server.close();
        client.close();
        Simulation floor = new Simulation(World.bare(), 1);
        try (P2osServer again =
                new P2osServer(simulation, InetAddress.getLoopbackAddress(), new SimulatorRequests() {})) {
            assertEquals(port, again.add(floor.addRobot("one"), port));
        }
    }

    @Test
    void noHostileInputTakesItDown() throws IOException {
        Random random = new Random(2026);
        for (int i = 0; i < HOSTILE_INPUTS; i++) {
            try (SocketClient hostile = new SocketClient(port)) {
                if (i % 3 == 0) {
                    hostile.open();
                }
                hostile.send(HostileInput.next(random));
            } catch (IOException droppedOnTheWay) {
                // it may be sent away in the middle of its nonsense
            }
            try (SocketClient fresh = SocketClient.opened(port)) {
                assertEquals(16, fresh.sip().sonars().size(), "after input " + i);
            }
        }
        try (SocketClient fresh = SocketClient.opened(port);
                SocketClient neighbour = SocketClient.opened(secondPort)) {
            assertNotNull(fresh.sip());
            assertEquals(0, neighbour.sip().x());
        }
    }
}
