package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The jars alone, copied into a folder without worlds beside it. */
class LoneJarsTest {
    @Test
    void theJarsCarryTheWorlds(@TempDir Path folder) throws Exception {
        Path dist = Dist.jar("simrobot").getParent();
        try (Stream<Path> files = Files.list(dist)) {
            for (Path jar :
                    files.filter(file -> file.toString().endsWith(".jar")).toList()) {
                Files.copy(jar, folder.resolve(jar.getFileName()));
            }
        }
        for (String[] world : new String[][] {{}, {"--world", "worlds/demo.map"}, {"--world", "office.map"}}) {
            assertEquals(print(dist, world), print(folder, world), String.join(" ", world));
        }
        assertTrue(print(folder, "--world", "nope.map").contains("nope.map: no such file"));
        assertTrue(print(folder, "--world", "elsewhere/demo.map").contains("elsewhere/demo.map: no such folder "));
    }

    private static String print(Path folder, String... world) throws Exception {
        List<String> command = new ArrayList<>(Dist.command("simrobot", List.of("--print-world")));
        command.set(
                command.indexOf(Dist.jar("simrobot").toString()),
                folder.resolve("simrobot.jar").toString());
        command.addAll(List.of(world));
        Process process = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
}
