package simgsm.classroom.demo;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import simgsm.air.Msisdn;
import simgsm.center.app.Center;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.ChildPrograms;
import simgsm.center.app.HomeSettings;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.ui.window.WindowMemory;

/** The demo's centre with its temporary data, and its phone and SimRobot as child processes. */
public final class DemoPrograms implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(DemoPrograms.class.getName());

    static final String PHONE_NUMBER = "5550100";
    static final String ROBOT_NUMBER = "5550200";
    private static final String WORLD = "worlds/demo.map";

    private final Arguments arguments;
    private final List<Path> temporary = new CopyOnWriteArrayList<>();
    private final Center center;
    private final ChildPrograms children;
    private final Thread atExit;

    private DemoPrograms(Arguments arguments, Center center, ChildPrograms children) {
        this.arguments = arguments;
        this.center = center;
        this.children = children;
        this.atExit = new Thread(this::end, "end of the demo");
        Runtime.getRuntime().addShutdownHook(atExit);
    }

    /** A closed network must list the SIMs of the phone and the robot. */
    private static void requireCards(HomeSettings home) throws UsageException {
        List<Msisdn> parts = List.of(new Msisdn(PHONE_NUMBER), new Msisdn(ROBOT_NUMBER));
        if (home.isClosed() && !home.numbers().containsAll(parts)) {
            throw new UsageException("--demo: expected SIMs of " + PHONE_NUMBER + " and " + ROBOT_NUMBER + " in "
                    + home.file().get());
        }
    }

    /** Opens the centre, on any free port if the default one is taken. The children are not started. */
    public static DemoPrograms open(Arguments arguments, CenterSettings settings) throws IOException, UsageException {
        requireCards(settings.home());
        ChildPrograms children = ChildPrograms.besideOwn();
        if (settings.data().isPresent()) {
            return new DemoPrograms(arguments, open(settings, settings.data().get()), children);
        }
        Path temporary = Files.createTempDirectory("simgsm-demo");
        try {
            DemoPrograms programs = new DemoPrograms(arguments, open(settings, temporary), children);
            programs.removeAtEnd(temporary);
            return programs;
        } catch (IOException e) {
            remove(temporary);
            throw e;
        }
    }

    private static Center open(CenterSettings settings, Path data) throws IOException {
        if (settings.port().isPresent()) {
            return Center.open(settings, data, settings.port().getAsInt());
        }
        try {
            return Center.open(settings, data, CenterSettings.DEFAULT_PORT);
        } catch (IOException e) {
            Center center = openAnywhere(settings, data, e);
            LOG.log(
                    System.Logger.Level.WARNING,
                    "port {0} is taken, perhaps by another demo; this one has port {1}",
                    String.valueOf(CenterSettings.DEFAULT_PORT),
                    String.valueOf(center.port()));
            return center;
        }
    }

    /** Opens it on a free port. @throws IOException the first failure where another port does not help */
    private static Center openAnywhere(CenterSettings settings, Path data, IOException first) throws IOException {
        try {
            return Center.open(settings, data, 0);
        } catch (IOException e) {
            throw first;
        }
    }

    public Center center() {
        return center;
    }

    public ChildPrograms children() {
        return children;
    }

    Process startPhone(ProcessBuilder.Redirect output, String... more) throws IOException {
        return children.start(
                "simgsm-phone.jar", PHONE_NUMBER, words(center.home().wordsFor(PHONE_NUMBER), more), output);
    }

    Process startRobot(ProcessBuilder.Redirect output, String... more) throws IOException {
        List<String> words = words(center.home().wordsFor(ROBOT_NUMBER), more);
        words.addAll(List.of("--world", WORLD));
        return children.start("simrobot.jar", ROBOT_NUMBER, words, output);
    }

    /**
     * Starts any program of the suite with the centre's address, this run's language and these options.
     *
     * @param number with which it registers; empty for one that does not
     */
    public Process start(String jar, String number, ProcessBuilder.Redirect output, List<String> options)
            throws IOException {
        List<String> own = number.isEmpty() ? List.of() : center.home().wordsFor(number);
        return children.start(jar, number, words(own, options.toArray(String[]::new)), output);
    }

    private List<String> words(List<String> own, String... more) {
        List<String> words = new ArrayList<>(own);
        words.addAll(List.of("--center", center.reachedAt()));
        words.addAll(List.of("--log-level", arguments.text("log-level").orElse("warning")));
        for (String passed : List.of("lang", "theme", "seed")) {
            arguments.text(passed).ifPresent(value -> words.addAll(List.of("--" + passed, value)));
        }
        String lessons = arguments.text("lessons").orElse("");
        if (!lessons.isEmpty()) {
            words.addAll(List.of("--lessons", Path.of(lessons).toAbsolutePath().toString()));
        }
        if (arguments.has("no-sound")) {
            words.add("--no-sound");
        }
        words.addAll(WindowMemory.passedOn(arguments));
        words.addAll(List.of(more));
        return words;
    }

    @Override
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(atExit);
        } catch (IllegalStateException e) {
            return; // The process is ending, and the hook does it.
        }
        end();
    }

    private void end() {
        children.close();
        center.close();
        temporary.forEach(DemoPrograms::remove);
    }

    /** Has a directory removed at the end, too, after the programs have ended; also if a signal ends this one. */
    public void removeAtEnd(Path directory) {
        temporary.add(directory);
    }

    /** Removes a directory with all that is in it, if it is there. */
    public static void remove(Path directory) {
        try {
            Files.walkFileTree(directory, new SimpleFileVisitor<>() {
                @Override
                public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
                    Files.delete(file);
                    return FileVisitResult.CONTINUE;
                }

                @Override
                public FileVisitResult postVisitDirectory(Path visited, IOException failure) throws IOException {
                    Files.delete(visited);
                    return FileVisitResult.CONTINUE;
                }
            });
        } catch (IOException e) {
            // The system removes temporary directories.
        }
    }
}
