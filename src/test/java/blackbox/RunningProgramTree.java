package blackbox;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A program that starts others, watched from outside. */
final class RunningProgramTree {
    private final Process process;
    private List<ProcessHandle> descendants = List.of();

    private RunningProgramTree(Process process) {
        this.process = process;
    }

    /** @param temporary where the program puts temporary files: once killed it cannot remove them */
    static RunningProgramTree start(Path temporary, String program, String... arguments) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(Dist.command(temporary, program, List.of(arguments)))
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD);
        builder.directory(Dist.root().toFile());
        builder.environment().remove("DISPLAY");
        return new RunningProgramTree(builder.start());
    }

    /** Waits until the program has started this many others. */
    void awaitDescendants(int count) throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(RunningProgram.PATIENCE_SECONDS);
        do {
            descendants = process.descendants().toList();
            if (System.nanoTime() > end || !process.isAlive()) {
                throw new AssertionError("started only " + descendants.size() + " of " + count + " processes");
            }
            // The operating system does not report new grandchildren: poll every 20 ms.
            process.waitFor(20, TimeUnit.MILLISECONDS);
        } while (descendants.size() < count);
    }

    void kill() throws InterruptedException {
        process.destroyForcibly().waitFor();
    }

    void awaitEndOfDescendants() throws Exception {
        for (ProcessHandle descendant : descendants) {
            descendant.onExit().get(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS);
        }
    }
}
