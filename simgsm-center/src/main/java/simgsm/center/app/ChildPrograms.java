package simgsm.center.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import simgsm.console.ProgramFolder;
import simgsm.console.QuickStart;
import simgsm.ui.window.WindowPlace;

/**
 * Other programs of the suite as child processes. Each reads its standard input from a pipe of this process and ends
 * with it, so all exit with this process, even on SIGKILL.
 */
public final class ChildPrograms implements AutoCloseable {
    private static final long FAREWELL_MILLIS = 8_000;
    /** Time for a program that writes an archive of its classes after its window is closed. */
    private static final long ARCHIVING_MILLIS = 60_000;

    private final ProgramFolder programs;
    private final List<Child> started = new CopyOnWriteArrayList<>();
    /** Programs without input, which its end does not end. */
    private final List<Process> tools = new CopyOnWriteArrayList<>();

    private record Child(String jar, String number, List<String> arguments, Process process, long farewellMillis) {}

    ChildPrograms(ProgramFolder programs) {
        this.programs = programs;
    }

    /**
     * Finds the programs in this program's folder.
     *
     * @throws IOException if this program runs neither from a jar nor from an image
     */
    public static ChildPrograms besideOwn() throws IOException {
        return new ChildPrograms(ProgramFolder.of(ChildPrograms.class));
    }

    /**
     * Starts a program. Its standard error is this program's; the caller reads or discards its standard output.
     *
     * @param number its telephone number; may be empty
     */
    public Process start(String jar, String number, List<String> arguments, ProcessBuilder.Redirect output)
            throws IOException {
        boolean hasWindow = !arguments.contains("--headless");
        List<String> options = QuickStart.options(programs, jar, hasWindow);
        List<String> command = programs.command(jar, options);
        command.addAll(arguments);
        Process process = new ProcessBuilder(command)
                .redirectInput(ProcessBuilder.Redirect.PIPE)
                .redirectOutput(output)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        started.removeIf(child -> child.number.equals(number) && !child.process.isAlive());
        long farewellMillis = QuickStart.writesAtEnd(options) ? ARCHIVING_MILLIS : FAREWELL_MILLIS;
        started.add(new Child(jar, number, List.copyOf(arguments), process, farewellMillis));
        return process;
    }

    /**
     * Starts a program that ends by itself and registers nowhere. Its standard error is merged into its standard
     * output, which the caller reads.
     *
     * @param folder working directory
     */
    public Process startTool(String jar, List<String> arguments, Path folder) throws IOException {
        return start(programs.command(jar, QuickStart.options(programs, jar, false)), arguments, folder);
    }

    /** Starts a Java source file as a program; see {@link #startTool}. */
    public Process startSource(Path source, List<String> arguments, Path folder) throws IOException {
        List<String> command = ProgramFolder.java(QuickStart.options());
        command.add(source.toString());
        return start(command, arguments, folder);
    }

    private Process start(List<String> command, List<String> arguments, Path folder) throws IOException {
        command.addAll(arguments);
        Process process = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        process.getOutputStream().close();
        tools.removeIf(tool -> !tool.isAlive());
        tools.add(process);
        return process;
    }

    /**
     * Restarts the first ended program of this jar with its number and arguments, so in its place and world. Its
     * standard output is discarded.
     *
     * @return the new process; empty if none has ended
     */
    public Optional<Process> startAgain(String jar) throws IOException {
        Optional<Child> ended = started.stream()
                .filter(child -> child.jar.equals(jar) && !child.process.isAlive() && !child.number.isEmpty())
                .findFirst();
        if (ended.isEmpty()) {
            return Optional.empty();
        }
        return Optional.of(start(jar, ended.get().number, ended.get().arguments, ProcessBuilder.Redirect.DISCARD));
    }

    /** The window's place of the first running program of this jar; empty if it was given none. */
    Optional<WindowPlace> placeOf(String jar) {
        return started.stream()
                .filter(child ->
                        child.jar.equals(jar) && child.process.isAlive() && child.arguments.contains("--window"))
                .map(child -> child.arguments.get(child.arguments.indexOf("--window") + 1))
                .map(WindowPlace::parse)
                .findFirst();
    }

    /**
     * Closes their standard input, and destroys those still running after 8 s, or 60 s in a run that writes archives;
     * tools at once.
     */
    @Override
    public void close() {
        tools.forEach(Process::destroyForcibly);
        for (Child child : started) {
            try {
                child.process.getOutputStream().close();
            } catch (IOException e) {
                // already ended
            }
        }
        long from = System.nanoTime();
        for (Child child : started) {
            await(child.process, from + TimeUnit.MILLISECONDS.toNanos(child.farewellMillis) - System.nanoTime());
        }
        started.clear();
    }

    private static void await(Process process, long nanos) {
        try {
            if (!process.waitFor(Math.max(0, nanos), TimeUnit.NANOSECONDS)) {
                process.destroyForcibly();
            }
        } catch (InterruptedException e) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
    }
}
