package simgsm.phone;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.ProcessBuilder.Redirect;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Consumer;
import simgsm.console.Arguments;
import simgsm.console.CommandException;
import simgsm.console.Event;
import simgsm.console.ProgramFolder;
import simgsm.console.QuickStart;
import simgsm.thread.DaemonThread;
import simgsm.ui.window.WindowOptions;

/** A lesson that is begun in a phone's help: the suite's demo with the lesson, beside the phone, which ends it. */
final class BegunLesson {
    private static final System.Logger LOG = System.getLogger(BegunLesson.class.getName());
    private static final List<String> FIELDS = List.of("lesson", "step", "result", "tries", "hints");
    private static final String JAR = "simgsm-center.jar";

    private BegunLesson() {}

    /** @param arguments of the phone, for the lessons' folder; @param results receives those fields of each result; any thread */
    static void start(String name, Arguments arguments, Consumer<String[]> results) {
        try {
            List<String> command = ProgramFolder.of(BegunLesson.class).command(JAR, QuickStart.options());
            command.addAll(List.of("--demo", "--lesson", name, "--console", "--port", "0"));
            command.addAll(WindowOptions.presentLook());
            arguments
                    .text("lessons")
                    .filter(folder -> !folder.isEmpty())
                    .ifPresent(folder -> command.addAll(List.of("--lessons", folder)));
            Process lesson =
                    new ProcessBuilder(command).redirectError(Redirect.INHERIT).start();
            DaemonThread.start("lesson", () -> read(lesson.inputReader(StandardCharsets.UTF_8), results));
        } catch (IOException e) {
            LOG.log(Level.WARNING, "the lesson has not begun: {0}", e.getMessage());
        }
    }

    /** Passes on the results among a program's printed lines. */
    static void read(BufferedReader printed, Consumer<String[]> results) {
        try (printed) {
            printed.lines().forEach(line -> {
                try {
                    Event event = Event.parse(line);
                    if (event.name().equals("lesson-result")) {
                        results.accept(FIELDS.stream().map(event.fields()::get).toArray(String[]::new));
                    }
                } catch (CommandException e) {
                    LOG.log(Level.DEBUG, "no event: {0}", line);
                }
            });
        } catch (IOException | UncheckedIOException e) {
            LOG.log(Level.DEBUG, "the lesson''s output broke: {0}", e.getMessage());
        }
    }
}
