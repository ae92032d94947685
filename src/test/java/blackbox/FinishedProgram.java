package blackbox;

import java.io.IOException;
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
        builder.directory(Dist.root().toFile());
        builder.environment().remove("DISPLAY");
        builder.environment().putAll(environment);
        Process process = builder.start();
        process.getOutputStream().close();
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
            throw new AssertionError(program + " " + arguments + " does not end");
        }
        return new FinishedProgram(process.exitValue(), output, error.toString());
    }
}
