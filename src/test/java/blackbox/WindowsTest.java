package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import simgsm.console.ProgramFolder;
import simgsm.console.QuickStart;

/** The three real windows on a display, where there is one (CI has a virtual one). */
@Isolated("one mouse, one keyboard, one screen")
class WindowsTest {
    @Test
    void keysPressedWithTheMouseMoveTheRobot(@TempDir Path data) throws Exception {
        assumeTrue(!System.getenv().getOrDefault("DISPLAY", "").isBlank(), "needs a display");
        int port;
        try (ServerSocket probe = new ServerSocket(0)) {
            port = probe.getLocalPort();
        }
        String classPath = Stream.concat(
                        Stream.of("simgsm-center", "simgsm-phone", "simrobot", "simgsm-modem", "vericommand")
                                .map(program -> Dist.jar(program).toString()),
                        Stream.of(Path.of(WindowSession.class
                                        .getProtectionDomain()
                                        .getCodeSource()
                                        .getLocation()
                                        .toURI())
                                .toString()))
                .collect(Collectors.joining(File.pathSeparator));
        List<String> command = ProgramFolder.java(QuickStart.options());
        command.addAll(List.of(
                "-cp",
                classPath,
                WindowSession.class.getName(),
                Integer.toString(port),
                data.resolve("data").toString(),
                Scenario.world("empty.map").toString()));
        Process process = new ProcessBuilder(command)
                .directory(Dist.root().toFile())
                .redirectErrorStream(true)
                .start();
        String told = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        System.out.println(told);
        assertTrue(process.waitFor(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS));
        assertEquals(0, process.exitValue(), told);
    }
}
