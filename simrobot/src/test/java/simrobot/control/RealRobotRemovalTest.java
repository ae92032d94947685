package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import simgsm.air.Msisdn;
import simgsm.net.LineAddress;
import simgsm.speech.AudioOutput;
import simgsm.speech.CallAudioListener;
import simgsm.speech.SpeechCodec;
import simrobot.process.BehaviourKind;
import simrobot.simulation.Simulation;
import simrobot.world.World;
import vericommand.VeriCommandSettings;

/** A real robot's connection to a peer that accepts it and sends nothing. */
@Timeout(60)
class RealRobotRemovalTest {
    private static final String THREADS = "pioneer real ";

    private SimRobot simRobot;
    private ServerSocket pioneer;
    private Socket connection;
    private TelephoneRobot robot;

    @BeforeEach
    void aConnectedRobot() throws Exception {
        pioneer = new ServerSocket(0, 10, InetAddress.getLoopbackAddress());
        Simulation simulation = new Simulation(World.bare(), 1);
        simRobot = new SimRobot(simulation, new InetSocketAddress(0), VeriCommandSettings.DEFAULT, AudioOutput.SILENT);
        Fleet.Kit kit = new Fleet.Kit(
                1,
                true,
                true,
                BehaviourKind.NONE,
                SpeechCodec.Kind.A_LAW,
                1500,
                Optional.empty(),
                Optional.empty(),
                name -> CallAudioListener.NONE,
                number -> Optional.empty());
        robot = new Fleet(simRobot, kit)
                .addReal(
                        new RobotName("real", new Msisdn("5550200")),
                        LineAddress.parse("127.0.0.1:" + pioneer.getLocalPort()),
                        Optional.empty(),
                        simulation,
                        Optional.empty());
        simRobot.start();
        connection = pioneer.accept();
    }

    @AfterEach
    void close() throws Exception {
        simRobot.close();
        connection.close();
        pioneer.close();
    }

    private static List<Thread> threads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(thread -> thread.getName().startsWith(THREADS))
                .toList();
    }

    private static void assertEnd(List<Thread> threads) throws InterruptedException {
        assertFalse(threads.isEmpty());
        for (Thread thread : threads) {
            thread.join(TimeUnit.SECONDS.toMillis(20));
            assertFalse(thread.isAlive(), thread.getName());
        }
    }

    @Test
    void removingARealRobotEndsItsConnectionAndItsThreads() throws Exception {
        List<Thread> threads = threads();
        simRobot.onSimulation(() -> {
            simRobot.remove(robot);
            return true;
        });
        assertEnd(threads);
        assertEquals(-1, lastOctet());
    }

    @Test
    void closingTheProgramEndsTheThreadsOfARealRobot() throws Exception {
        List<Thread> threads = threads();
        simRobot.close();
        assertEnd(threads);
        assertEquals(-1, lastOctet());
    }

    private int lastOctet() throws Exception {
        connection.setSoTimeout(20_000);
        int octet = connection.getInputStream().read();
        while (octet >= 0) {
            octet = connection.getInputStream().read();
        }
        return octet;
    }
}
