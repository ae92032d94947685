package simgsm.classroom.session;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.center.app.Center;
import simgsm.center.app.CenterSettings;
import simgsm.center.app.ChildPrograms;
import simgsm.center.app.HomeSettings;
import simgsm.center.msc.ExchangeEvent;
import simgsm.console.Arguments;
import simgsm.console.Event;
import simgsm.console.UsageException;
import simgsm.ui.window.WindowMemory;

/** A centre with a temporary folder, and other programs of the suite as child processes. */
public final class Session implements AutoCloseable {
    private static final System.Logger LOG = System.getLogger(Session.class.getName());

    /** Name of the centre as a source of events. */
    public static final String CENTRE = "centre";

    public static final String PHONE_NUMBER = "5550100";
    public static final String ROBOT_NUMBER = "5550200";

    private final Arguments arguments;
    private final Path folder;
    private final Center center;
    private final ChildPrograms children;
    private final Consoles consoles = new Consoles();
    private final Thread atExit = new Thread(this::end, "end of the session");

    /** Makes the settings of the centre. */
    public interface Settings {
        /** @param folder of the session, removed at its end */
        CenterSettings in(Path folder) throws IOException, UsageException;
    }

    private Session(Arguments arguments, Path folder, Center center, ChildPrograms children) {
        this.arguments = arguments;
        this.folder = folder;
        this.center = center;
        this.children = children;
        Runtime.getRuntime().addShutdownHook(atExit);
    }

    /** Opens the centre; without a port in the settings it uses any free one if the default is taken. */
    public static Session open(Arguments arguments, Settings settings) throws IOException, UsageException {
        ChildPrograms children = ChildPrograms.besideOwn();
        Path folder = Files.createTempDirectory("simgsm-demo");
        try {
            CenterSettings made = settings.in(folder);
            requireCards(made.home());
            Path data = made.data().orElse(folder.resolve("data"));
            return new Session(arguments, folder, center(made, data), children);
        } catch (IOException | UsageException | RuntimeException e) {
            remove(folder);
            throw e;
        }
    }

    /** A closed network must list the SIMs of the phone and the robot. */
    private static void requireCards(HomeSettings home) throws UsageException {
        List<Msisdn> parts = List.of(new Msisdn(PHONE_NUMBER), new Msisdn(ROBOT_NUMBER));
        if (home.isClosed() && !home.numbers().containsAll(parts)) {
            throw new UsageException("--demo: expected SIMs of " + PHONE_NUMBER + " and " + ROBOT_NUMBER + " in "
                    + home.file().get());
        }
    }

    private static Center center(CenterSettings settings, Path data) throws IOException {
        if (settings.port().isPresent()) {
            return Center.open(settings, data, settings.port().getAsInt());
        }
        try {
            return Center.open(settings, data, CenterSettings.DEFAULT_PORT);
        } catch (IOException first) {
            Center center;
            try {
                center = Center.open(settings, data, 0);
            } catch (IOException e) {
                throw first; // another port would not help
            }
            LOG.log(
                    System.Logger.Level.WARNING,
                    "port {0} is taken, perhaps by another demo; this one has port {1}",
                    String.valueOf(CenterSettings.DEFAULT_PORT),
                    String.valueOf(center.port()));
            return center;
        }
    }

    public Path folder() {
        return folder;
    }

    public Center center() {
        return center;
    }

    public ChildPrograms children() {
        return children;
    }

    public Consoles consoles() {
        return consoles;
    }

    /** Adds the centre's events to those of the programs. */
    public Consumer<ExchangeEvent> centerEvents() {
        return event -> consoles.print(CENTRE, Event.from(event));
    }

    /**
     * Starts a program of the suite with the centre's address, this run's language and these options.
     *
     * @param name of its console
     * @param jar without its extension
     * @param number for its registration; empty for the gateway, which also has no window
     */
    public void start(String name, String jar, String number, List<String> options) throws IOException {
        List<String> words =
                new ArrayList<>(number.isEmpty() ? List.of() : center.home().wordsFor(number));
        words.addAll(List.of("--center", center.reachedAt()));
        words.addAll(List.of("--log-level", arguments.text("log-level").orElse("warning")));
        List<String> shared = number.isEmpty() ? List.of("lang") : List.of("lang", "theme", "seed");
        for (String passed : shared) {
            arguments.text(passed).ifPresent(value -> words.addAll(List.of("--" + passed, value)));
        }
        if (!number.isEmpty()) {
            words.addAll(windowOptions());
        }
        words.addAll(options);
        consoles.attach(name, children.start(jar + ".jar", number, words, ProcessBuilder.Redirect.PIPE));
    }

    private List<String> windowOptions() {
        List<String> words = new ArrayList<>(WindowMemory.passedOn(arguments));
        words.add("--end-with-input"); // its windows pass a lesson chosen in their help on to the session
        arguments
                .text("lessons")
                .filter(lessons -> !lessons.isEmpty())
                .ifPresent(lessons -> words.addAll(
                        List.of("--lessons", Path.of(lessons).toAbsolutePath().toString())));
        if (arguments.has("no-sound")) {
            words.add("--no-sound");
        }
        return words;
    }

    @Override
    public void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(atExit);
        } catch (IllegalStateException e) {
            return; // the process is ending, and the hook deletes the folder
        }
        end();
    }

    private void end() {
        children.close();
        center.close();
        remove(folder);
    }

    private static void remove(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            files.sorted(Comparator.reverseOrder()).map(Path::toFile).forEach(File::delete);
        } catch (IOException | UncheckedIOException e) {
            // The system removes temporary directories.
        }
    }
}
