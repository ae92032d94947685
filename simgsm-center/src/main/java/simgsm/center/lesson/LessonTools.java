package simgsm.center.lesson;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import simgsm.center.app.ChildPrograms;
import simgsm.console.Event;

/** Runs tools in the folder of a lesson and makes an event of what they print. */
final class LessonTools {
    private static final int PATIENCE_SECONDS = 60;

    private final ChildPrograms programs;
    private final Path folder;

    LessonTools(ChildPrograms programs, Path folder) {
        this.programs = programs;
        this.folder = folder;
    }

    /** What a program has printed, standard error included, and its exit status. */
    record Printed(int status, String output) {
        /** The first complaint, for a message of one line. */
        String lastLine() {
            return output.lines().reduce((first, second) -> second).orElse("");
        }
    }

    /**
     * A tool of {@code simgsm-modem.jar}: an event with the tool's name, {@code status} and {@code output}; for {@code
     * decode} also {@code keys} and {@code count}.
     */
    Event tool(List<String> words) throws IOException, InterruptedException {
        Printed printed = jar("simgsm-modem.jar", words);
        Event event = Event.of(words.get(0))
                .with("status", printed.status())
                .with("output", printed.output().strip());
        if (words.get(0).equals("decode")) {
            String[] columns = printed.output().lines().findFirst().orElse("").split("\t", -1);
            String keys = columns.length > 1 ? columns[1] : "";
            return event.with("keys", keys).with("count", keys.length());
        }
        return event;
    }

    Printed jar(String jar, List<String> words) throws IOException, InterruptedException {
        return ended(programs.startTool(jar, words, folder));
    }

    /** A Java source file: an event {@code java status= output=}. */
    Event source(List<String> words) throws IOException, InterruptedException {
        Path file = folder.resolve(words.get(0));
        Printed printed = ended(programs.startSource(file, words.subList(1, words.size()), folder));
        return Event.of("java")
                .with("status", printed.status())
                .with("output", printed.output().strip());
    }

    private static Printed ended(Process process) throws IOException, InterruptedException {
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        if (!process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            process.destroyForcibly();
            throw new IOException("a tool has not ended within " + PATIENCE_SECONDS + " s");
        }
        return new Printed(process.exitValue(), output);
    }
}
