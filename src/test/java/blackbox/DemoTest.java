package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;

/** The main job: {@code simgsm-center.jar --demo}. */
@ResourceLock("port 3003")
class DemoTest {
    @Test
    void withoutADisplayTheDemoPlaysASessionAndPrintsItsTranscript() throws Exception {
        FinishedProgram demo;
        try (ServerSocket taken = new ServerSocket()) {
            takeDefaultPort(taken);
            demo = FinishedProgram.run("simgsm-center", "--demo", "--lang", "en");
        }
        assertTrue(demo.error().contains("port 3003 is taken"), demo.error());
        assertEquals(0, demo.status(), demo.output() + demo.error());
        for (String shown : new String[] {"1", "6", "3", "4"}) {
            assertTrue(
                    demo.output().lines().anyMatch(line -> line.matches(".*tone.*\\b" + shown + "\\b.*")),
                    "tone " + shown + " in\n" + demo.output());
        }
        assertTrue(demo.output().contains("** #**20 **") || demo.output().contains("**#**20**"), demo.output());
        assertTrue(demo.output().toLowerCase().contains("sms"), demo.output());
        assertTrue(demo.output().contains("Collision"), demo.output());
    }

    private static void takeDefaultPort(ServerSocket held) {
        try {
            held.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 3003));
        } catch (IOException e) {
            // Another program has it, which serves as well.
        }
    }

    @Test
    void aDemoWithoutAPortLeavesNoFolderBehind(@TempDir Path temporary) throws Exception {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            String port = Integer.toString(taken.getLocalPort());
            List<String> command =
                    Dist.command(temporary, "simgsm-center", List.of("--demo", "--headless", "--port", port));
            FinishedProgram demo = FinishedProgram.of(new ProcessBuilder(command), new byte[0]);
            assertEquals(74, demo.status(), demo.output() + demo.error());
            assertTrue(demo.error().contains("port " + port), demo.error());
        }
        try (Stream<Path> left = Files.list(temporary)) {
            assertEquals(List.of(), left.toList());
        }
    }

    @Test
    void theDemosProcessesEndWithTheCentreEvenWhenItIsKilled(@TempDir Path temporary) throws Exception {
        RunningProgramTree demo = RunningProgramTree.start(temporary, "simgsm-center", "--demo");
        demo.awaitDescendants(2);
        demo.kill();
        demo.awaitEndOfDescendants();
    }
}
