package simgsm.classroom.lesson;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import simgsm.center.app.ChildPrograms;
import simgsm.console.Event;
import simgsm.thread.DaemonThread;

/** Runs tools in the folder of a lesson and converts their output to events. */
final class LessonTools {
    private static final int PATIENCE_SECONDS = 60;
    /** Maximum kept output of a tool, in octets. */
    static final int MOST_OUTPUT = 1 << 20;

    /** Field of a tool's event: the tool's arguments. */
    static final String OPTIONS = "options";

    private final ChildPrograms programs;
    private final Path folder;

    LessonTools(ChildPrograms programs, Path folder) {
        this.programs = programs;
        this.folder = folder;
    }

    /** A program's output, standard error included, and its exit status. */
    record Printed(int status, String output) {
        /** The last line of the output, for a message of one line. */
        String lastLine() {
            return output.lines().reduce((first, second) -> second).orElse("");
        }
    }

    /**
     * A tool of {@code simgsm-modem.jar}: an event with the tool's name, {@code status}, {@code output} and {@code options},
     * the words after its name; for {@code decode} also {@code keys} and {@code count}, for {@code hear} as {@code count} the words that
     * their files are named after.
     */
    Event tool(List<String> words) throws IOException, InterruptedException {
        Printed printed = jar("simgsm-modem.jar", words);
        Event event = Event.of(words.get(0))
                .with("status", printed.status())
                .with("output", printed.output().strip())
                .with(OPTIONS, String.join(" ", words.subList(1, words.size())));
        if (words.get(0).equals("decode")) {
            String[] columns = printed.output().lines().findFirst().orElse("").split("\t", -1);
            String keys = columns.length > 1 ? columns[1] : "";
            return event.with("keys", keys).with("count", keys.length());
        }
        if (words.get(0).equals("hear")) {
            return event.with(
                    "count",
                    printed.output()
                            .lines()
                            .filter(line -> line.matches("(.*/)?([^/]+)\\.wav\t\\2\t.*"))
                            .count());
        }
        return event;
    }

    Printed jar(String jar, List<String> words) throws IOException, InterruptedException {
        return ended(programs.startTool(jar, words, folder));
    }

    /** Runs a Java source file; returns an event {@code java status= output=}. */
    Event source(List<String> words) throws IOException, InterruptedException {
        Path file = folder.resolve(words.get(0));
        Printed printed = ended(programs.startSource(file, words.subList(1, words.size()), folder));
        return Event.of("java")
                .with("status", printed.status())
                .with("output", printed.output().strip());
    }

    private static Printed ended(Process process) throws IOException, InterruptedException {
        return ended(process, PATIENCE_SECONDS);
    }

    /**
     * Waits for the end of a program and ends it after a timeout: a student's program may never end, nor its output.
     */
    static Printed ended(Process process, long seconds) throws IOException, InterruptedException {
        FutureTask<byte[]> output = new FutureTask<>(() -> read(process.getInputStream()));
        DaemonThread.start("output of a tool", output::run);
        try {
            if (!process.waitFor(seconds, TimeUnit.SECONDS)) {
                throw new IOException("a tool has not ended within " + seconds + " s");
            }
            String text = new String(output.get(seconds, TimeUnit.SECONDS), StandardCharsets.UTF_8);
            return new Printed(process.exitValue(), text);
        } catch (ExecutionException | TimeoutException e) {
            throw new IOException("the output of a tool cannot be read", e);
        } finally {
            process.destroyForcibly();
        }
    }

    /** Reads an output to its end and returns its beginning. */
    private static byte[] read(InputStream in) throws IOException {
        byte[] first = in.readNBytes(MOST_OUTPUT);
        in.transferTo(OutputStream.nullOutputStream());
        return first;
    }
}
