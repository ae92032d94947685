package simgsm.classroom.lesson;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.classroom.session.Session;
import simgsm.classroom.session.SessionFailure;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.ExitStatus;
import simgsm.console.Program;
import simgsm.console.UsageException;
import simgsm.file.FileErrors;
import simgsm.lesson.Lesson;
import simgsm.lesson.LessonException;
import simgsm.lesson.LessonLibrary;
import simgsm.lesson.LessonProgram;
import simgsm.lesson.LessonRun;
import simgsm.lesson.LessonStep;
import simgsm.lesson.LessonTexts;

/** {@code --lessons}, and {@code --lesson NAME --check SOLUTION}: plays a lesson without windows and marks it. */
public final class LessonCheck {
    private static final System.Logger LOG = System.getLogger(LessonCheck.class.getName());
    /** The default seed of a student's numbers. */
    static final long FIRST_SEED = 1;
    /** Wait after the last action; the trace is read every 100 ms. */
    private static final long SETTLE_MILLIS = 250;

    private static final String UNSEEN_SPEED = "25";

    /** A lesson and its texts in the user's language. */
    record Named(Lesson lesson, LessonTexts texts) {}

    private LessonCheck() {}

    /** Prints the lessons, and on standard error an error for each unreadable one of a teacher. */
    public static int list(Arguments arguments) throws UsageException {
        LessonLibrary library = LessonLibrary.of(arguments);
        PrintStream out = Program.standardOutput();
        int status = ExitStatus.OK;
        for (String name : library.names()) {
            try {
                Lesson lesson = read(library, name);
                out.print(Event.of("lesson")
                                .with("name", name)
                                .with(
                                        "title",
                                        library.texts(lesson, arguments.language())
                                                .of("title"))
                                .with("minutes", lesson.minutes())
                        + "\n");
            } catch (LessonException e) {
                System.err.println("simgsm-center: " + e.getMessage());
                status = ExitStatus.FAILED;
            }
        }
        out.flush();
        return status;
    }

    /** Reads a lesson and checks that its values can be computed. */
    private static Lesson read(LessonLibrary library, String name) throws LessonException {
        Lesson lesson = library.lesson(name);
        try {
            new LessonRun(lesson, FIRST_SEED, new LessonFigures());
        } catch (IllegalArgumentException e) {
            throw new LessonException(e.getMessage());
        }
        return lesson;
    }

    /** Plays a solution and prints a line for each step, then the score. */
    public static int run(Arguments arguments)
            throws UsageException, IOException, LessonException, InterruptedException {
        LessonLibrary library = LessonLibrary.of(arguments);
        Locale language = arguments.language();
        Named named = named(library, arguments);
        Lesson lesson = named.lesson();
        Solution solution =
                Solution.of(library, lesson.name(), arguments.text("check").orElseThrow());
        Optional<Path> result = arguments.path("result");
        if (result.isPresent()) {
            FileErrors.requireWritable(result.get());
        }
        LessonRun run = new LessonRun(lesson, seed(arguments), new LessonFigures());
        try (Session network = LessonNetwork.open(lesson, arguments)) {
            LessonSession session =
                    new LessonSession(run, network, library.folder(lesson.name()), LessonCheck::options, language);
            network.center().publishSnapshots(session.trace());
            network.center().start(session.centerEvents());
            play(session, solution);
            String score = session.ofRun(each -> score(each, named.texts()));
            Program.standardOutput().print(score);
            Program.standardOutput().flush();
            if (result.isPresent()) {
                String text = session.ofRun(each -> ResultText.text(each, "", Instant.now(), language));
                Files.writeString(result.get(), text);
            }
        }
        return run.score() == lesson.steps().size() ? ExitStatus.OK : ExitStatus.FAILED;
    }

    /** Options of a program; without a window the robot may drive at a higher pace than in class. */
    private static List<String> options(LessonProgram program) {
        return program.jar().equals("simrobot")
                ? List.of("--headless", "--no-sound", "--speed", UNSEEN_SPEED)
                : List.of("--headless", "--no-sound");
    }

    /** Reads the lesson of {@code --lesson} with its texts. */
    static Named named(LessonLibrary library, Arguments arguments) throws UsageException {
        try {
            Lesson lesson = read(library, arguments.text("lesson").orElseThrow());
            return new Named(lesson, library.texts(lesson, arguments.language()));
        } catch (LessonException e) {
            throw new UsageException("--lesson: " + e.getMessage());
        }
    }

    static long seed(Arguments arguments) throws UsageException {
        return arguments.integer("seed", FIRST_SEED, Long.MIN_VALUE, Long.MAX_VALUE);
    }

    private static void play(LessonSession session, Solution solution) throws IOException, InterruptedException {
        try {
            session.start();
            solution.play(session);
            Thread.sleep(SETTLE_MILLIS);
        } catch (SessionFailure e) {
            LOG.log(System.Logger.Level.WARNING, e.getMessage());
        }
    }

    /** Returns a line for each step, then the score. */
    private static String score(LessonRun run, LessonTexts texts) {
        StringBuilder lines = new StringBuilder();
        for (LessonStep step : run.lesson().steps()) {
            lines.append(Event.of("check")
                            .with("step", step.name())
                            .with("result", run.result(step.name()).word())
                            .with("text", run.shown(texts.of("step " + step.name()))))
                    .append('\n');
        }
        return lines + "score=" + run.score() + " of=" + run.lesson().steps().size() + "\n";
    }
}
