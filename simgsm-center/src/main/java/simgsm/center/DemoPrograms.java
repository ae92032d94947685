package simgsm.center;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simgsm.console.Arguments;
import simgsm.console.UsageException;

/** The demo's centre with its temporary data, and the phone and the SimRobot that go with it. */
final class DemoPrograms implements AutoCloseable {
    static final String PHONE_NUMBER = "5550100";
    static final String ROBOT_NUMBER = "5550200";
    private static final String WORLD = "worlds/demo.map";

    private final Arguments arguments;
    private final Path data;
    private final Center center;
    private final Children children;
    private final Thread atExit;

    private DemoPrograms(Arguments arguments, Path data, Center center, Children children) {
        this.arguments = arguments;
        this.data = data;
        this.center = center;
        this.children = children;
        this.atExit = new Thread(this::end, "end of the demo");
    }

    /** Opens the centre, on a free port if the usual one is taken; the children are not started yet. */
    static DemoPrograms open(Arguments arguments) throws IOException, UsageException {
        Children children = Children.besideUs();
        Optional<Path> given = arguments.path("data");
        Path data = given.isPresent() ? given.get() : Files.createTempDirectory("simgsm-demo");
        DemoPrograms programs =
                new DemoPrograms(arguments, given.isPresent() ? null : data, open(arguments, data), children);
        Runtime.getRuntime().addShutdownHook(programs.atExit);
        return programs;
    }

    private static Center open(Arguments arguments, Path data) throws IOException, UsageException {
        try {
            return CenterMain.open(arguments, data, CenterMain.port(arguments, CenterMain.DEFAULT_PORT));
        } catch (IOException e) {
            if (arguments.has("port")) {
                throw e;
            }
            return CenterMain.open(arguments, data, 0);
        }
    }

    Center center() {
        return center;
    }

    Children children() {
        return children;
    }

    Process startPhone(ProcessBuilder.Redirect output, String... more) throws IOException {
        return children.start("simgsm-phone.jar", words(List.of("--number", PHONE_NUMBER), more), output);
    }

    Process startRobot(ProcessBuilder.Redirect output, String... more) throws IOException {
        return children.start("simrobot.jar", words(List.of("--number", ROBOT_NUMBER, "--world", WORLD), more), output);
    }

    private List<String> words(List<String> own, String... more) {
        List<String> words = new ArrayList<>(own);
        words.addAll(List.of("--center", "127.0.0.1:" + center.port()));
        words.addAll(List.of("--log-level", arguments.text("log-level").orElse("warning")));
        for (String passed : List.of("lang", "theme", "seed")) {
            arguments.text(passed).ifPresent(value -> words.addAll(List.of("--" + passed, value)));
        }
        if (arguments.has("no-sound")) {
            words.add("--no-sound");
        }
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
        if (data != null) {
            remove(data);
        }
    }

    private static void remove(Path directory) {
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
            // It is a temporary directory; the system sweeps it sooner or later.
        }
    }
}
