package simrobot.simulation;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The speed comparison, with the finished program: robot-seconds of simulation per CPU second, a run of one second
 * subtracted. Start it in the source tree after {@code mvn -DskipTests package}:
 *
 * <pre>
 *   java -cp simrobot/target/test-classes simrobot.simulation.WanderBench [target/dist/simrobot.jar]
 * </pre>
 */
public final class WanderBench {
    /** Stage 4.3 with the same rule and worlds, measured on a machine of the same kind. */
    private static final int[][] ROBOTS_SECONDS_STAGE = {
        {1, 6000, 2600}, {10, 2000, 4900}, {100, 600, 3200}, {1000, 100, 1500}, {10000, 20, 0}
    };

    private static final Pattern RAN = Pattern.compile("ran .*cpu=([0-9.]+) wall=([0-9.]+)");
    private static final int REPEATS = 3;

    private WanderBench() {}

    public static void main(String[] args) throws IOException, InterruptedException {
        Path jar = Path.of(args.length > 0 ? args[0] : "target/dist/simrobot.jar");
        Path folder = Files.createTempDirectory("wander");
        System.out.println("| robots | world m | start-up CPU s | robot-seconds per CPU second | times Stage |");
        System.out.println("|---|---|---|---|---|");
        Path world = folder.resolve("wander.map");
        try {
            for (int[] row : ROBOTS_SECONDS_STAGE) {
                Files.writeString(world, WanderWorld.map(row[0], 1));
                double startUp = median(jar, world, 1);
                double run = median(jar, world, row[1]);
                double figure = row[0] * (row[1] - 1.0) / (run - startUp);
                System.out.println(String.format(
                        Locale.ROOT,
                        "| %d | %d | %.2f | %.0f | %s |",
                        row[0],
                        WanderWorld.sideMeters(row[0]),
                        startUp,
                        figure,
                        row[2] == 0 ? "" : String.format(Locale.ROOT, "%.1f", figure / row[2])));
            }
        } finally {
            Files.deleteIfExists(world);
            Files.delete(folder);
        }
    }

    private static double median(Path jar, Path world, int seconds) throws IOException, InterruptedException {
        double[] cpu = new double[REPEATS];
        for (int i = 0; i < REPEATS; i++) {
            cpu[i] = cpuSeconds(jar, world, seconds);
        }
        java.util.Arrays.sort(cpu);
        return cpu[REPEATS / 2];
    }

    private static double cpuSeconds(Path jar, Path world, int seconds) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-jar",
                        jar.toString(),
                        "--world",
                        world.toString(),
                        "--robots",
                        "all",
                        "--behaviour",
                        "wander",
                        "--headless",
                        "--run",
                        Integer.toString(seconds))
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        Matcher ran = RAN.matcher(out);
        if (process.waitFor() > 1 || !ran.find()) {
            throw new IOException("the run failed: " + out);
        }
        return Double.parseDouble(ran.group(1));
    }
}
