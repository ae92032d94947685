package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The jars alone, copied into a folder without worlds beside it. */
class LoneJarsTest {
    private static final Path DIST = Dist.jar("simrobot").getParent();

    @TempDir
    private Path folder;

    @BeforeEach
    void copyTheJars() throws IOException {
        try (Stream<Path> files = Files.list(DIST)) {
            for (Path jar :
                    files.filter(file -> file.toString().endsWith(".jar")).toList()) {
                Files.copy(jar, folder.resolve(jar.getFileName()));
            }
        }
    }

    @Test
    void theJarsCarryTheWorlds() throws Exception {
        for (String[] world : new String[][] {{}, {"--world", "worlds/demo.map"}, {"--world", "office.map"}}) {
            assertEquals(world(DIST, world), world(folder, world), String.join(" ", world));
        }
        assertTrue(world(folder, "--world", "nope.map").contains("nope.map: no such file"));
        assertTrue(world(folder, "--world", "elsewhere/demo.map").contains("elsewhere/demo.map: no such folder "));
    }

    @Test
    void theJarsCarryTheTowns() throws Exception {
        for (String town : List.of("worlds/avenue.town", "village.town")) {
            assertEquals(town(DIST, town), town(folder, town), town);
        }
        assertTrue(town(folder, "worlds/avenue.town").contains("network"));
        assertTrue(town(folder, "nope.town").contains("nope.town: no such file"));
        assertTrue(town(folder, "elsewhere/avenue.town").contains("elsewhere/avenue.town: no such folder "));
    }

    private static String world(Path folder, String... world) throws Exception {
        List<String> arguments = new ArrayList<>(List.of("--print-world"));
        arguments.addAll(List.of(world));
        return print(folder, "simrobot", arguments);
    }

    private static String town(Path folder, String town) throws Exception {
        return print(folder, "simgsm-cells", List.of("--print-osmo-bsc", "--town", town));
    }

    private static String print(Path folder, String program, List<String> arguments) throws Exception {
        List<String> command = new ArrayList<>(Dist.command(program, arguments));
        String jar = Dist.jar(program).toString();
        command.set(command.indexOf(jar), folder.resolve(program + ".jar").toString());
        Process process = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
}
