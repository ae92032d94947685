package blackbox;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** A program that was started, ran to its end, and what it left: exit status, standard output, standard error. */
public record FinishedProgram(int status, String output, String error) {
    public static FinishedProgram run(String program, String... arguments) throws IOException, InterruptedException {
        return run(program, List.of(arguments), Map.of());
    }

    /** @param environment added to the tests' own, DISPLAY taken away */
    public static FinishedProgram run(String program, List<String> arguments, Map<String, String> environment)
            throws IOException, InterruptedException {
        ProcessBuilder builder = new ProcessBuilder(Dist.command(program, arguments));
        builder.environment().remove("DISPLAY");
        builder.environment().putAll(environment);
        return of(builder, new byte[0]);
    }

    /**
     * Starts a program in the suite's folder and waits for its end.
     *
     * @param input its standard input, at most what a pipe holds
     */
    public static FinishedProgram of(ProcessBuilder builder, byte[] input) throws IOException, InterruptedException {
        builder.directory(Dist.root().toFile());
        Process process = builder.start();
        try (OutputStream in = process.getOutputStream()) {
            in.write(input);
        }
        StringBuilder error = new StringBuilder();
        Thread errorReader = new Thread(() -> {
            try {
                error.append(new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8));
            } catch (IOException e) {
                error.append(e.getMessage());
            }
        });
        errorReader.start();
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        errorReader.join();
        if (!process.waitFor(RunningProgram.PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            process.destroyForcibly();
            throw new AssertionError(builder.command() + " does not end");
        }
        return new FinishedProgram(process.exitValue(), output, error.toString());
    }
}
