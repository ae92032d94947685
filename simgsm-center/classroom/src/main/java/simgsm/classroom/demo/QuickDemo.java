package simgsm.classroom.demo;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.ProgramFolder;
import simgsm.console.QuickStart;
import simgsm.thread.DaemonThread;

/**
 * Starts the demo's centre in a second Java process with the options of {@link QuickStart}, which a jar's manifest
 * cannot hold, and waits for its end. Both end together.
 */
public final class QuickDemo {
    /** Property that marks the second process. */
    private static final String SECOND = "simgsm.quick";

    private static final String JAR = "simgsm-center.jar";
    /** Options of runs without a window. */
    private static final String[] WINDOWLESS = {"--headless", "--help", "-h", "--version", "-V", "--new-sim", "--check"
    };

    private static final long FAREWELL_SECONDS = 10;
    private static final int BLOCK = 4096;

    private QuickDemo() {}

    /**
     * Runs the demo in a second process. Called before any other class of the program is loaded, because that takes as
     * long as the start of the second process.
     *
     * @param words the command line, not checked yet
     * @return its exit status; empty if the program has to run in this process: without the demo's windows, from an
     * image, in the second process, with Java options chosen by the user, or if no process can be started
     */
    public static OptionalInt run(String... words) {
        if (!isDemo(words) || System.getProperty(SECOND) != null || !mayHaveDisplay()) {
            return OptionalInt.empty();
        }
        try {
            ProgramFolder programs = ProgramFolder.of(QuickDemo.class);
            if (programs.isImage() || !isPlainCommand()) {
                return OptionalInt.empty();
            }
            return OptionalInt.of(run(programs, words));
        } catch (IOException e) {
            return OptionalInt.empty();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return OptionalInt.of(ExitStatus.FAILED);
        }
    }

    /** True if the words request the demo in windows; {@code --lessons DIR} then names its folder of lessons. */
    public static boolean isDemo(String... words) {
        for (String windowless : WINDOWLESS) {
            if (has(words, windowless)) {
                return false;
            }
        }
        return has(words, "--demo");
    }

    private static boolean has(String[] words, String option) {
        for (String word : words) {
            if (word.equals(option) || word.startsWith(option + "=")) {
                return true;
            }
        }
        return false;
    }

    private static int run(ProgramFolder programs, String... words) throws IOException, InterruptedException {
        List<String> options = new ArrayList<>(QuickStart.options(programs, JAR, true));
        options.add("-D" + SECOND + "=true");
        options.add("-D" + Program.IN_TERMINAL + "=" + (System.console() != null));
        List<String> command = programs.command(JAR, options);
        command.addAll(List.of(words));
        command.add("--end-with-input");
        Process second = new ProcessBuilder(command)
                .redirectOutput(ProcessBuilder.Redirect.INHERIT)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        Runtime.getRuntime().addShutdownHook(new Thread(() -> end(second), "end of the demo"));
        if (has(words, "--end-with-input") || has(words, "--console")) {
            passInput(second);
        }
        return second.waitFor();
    }

    /** True if a display may exist; checked without loading the desktop's libraries. */
    private static boolean mayHaveDisplay() {
        String system = System.getProperty("os.name");
        return system.startsWith("Windows")
                || system.startsWith("Mac")
                || !System.getenv().getOrDefault("DISPLAY", "").isBlank();
    }

    private static boolean isPlainCommand() {
        Optional<String[]> given = ProcessHandle.current().info().arguments();
        return given.isPresent() && given.get().length > 0 && given.get()[0].equals("-jar");
    }

    private static void end(Process second) {
        try {
            second.getOutputStream().close();
            if (!second.waitFor(FAREWELL_SECONDS, TimeUnit.SECONDS)) {
                second.destroy();
            }
        } catch (IOException | InterruptedException e) {
            second.destroy();
        }
    }

    /** The console's commands, and the end of the input. */
    private static void passInput(Process second) {
        DaemonThread.start("input", () -> {
            try {
                OutputStream input = second.getOutputStream();
                byte[] block = new byte[BLOCK];
                for (int count = System.in.read(block); count >= 0; count = System.in.read(block)) {
                    input.write(block, 0, count);
                    input.flush();
                }
                input.close();
            } catch (IOException e) {
                second.destroy();
            }
        });
    }
}
