package simrobot.source;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import simgsm.thread.DaemonThread;
import simrobot.behaviour.BehaviourAnswer;
import simrobot.behaviour.BehaviourRequest;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.process.Decision;
import simrobot.source.child.FaultPlace;
import simrobot.source.child.ProcessOutput;

/**
 * Updates a list of processes from a folder: each {@code .java} file is one process, named after its class, and each
 * jar provides those that it names as services. A thread scans every 500 ms; after a change all sources are compiled,
 * because one may use another. A file with an error keeps the process of its last valid version.
 */
public final class BehaviourFolder implements AutoCloseable {
    /** Is told of changes on the scanning thread. */
    public interface Listener {
        /** A process is new or changed. */
        default void loaded(BehaviourKind kind) {}

        /**
         * A file makes no process.
         *
         * @param line 0 if unknown
         */
        default void failed(String name, int line, String text) {}

        default void removed(String name) {}
    }

    private static final Logger LOG = System.getLogger(BehaviourFolder.class.getName());
    private static final long PERIOD_MILLIS = 500;
    /** A file's time of modification and size. */
    private record Stamp(long millis, long size) {}

    private final Path folder;
    private final BehaviourList list;
    private final BehaviourFiles files;
    private final Predicate<Path> chosen;
    private final Thread thread = DaemonThread.of("behaviour folder", this::look);
    private Map<Path, Stamp> seen = Map.of();
    private final Map<Path, Set<String>> names = new HashMap<>();
    private volatile Listener listener;
    /** Null while numbers are not kept. */
    private NumbersFile numbers;

    private boolean isLive;

    /**
     * Scans the folder once.
     *
     * @param chosen the files that may be processes; others are read only where these use them
     * @throws NotDirectoryException if the path is no folder
     */
    public BehaviourFolder(Path folder, BehaviourList list, ChildSettings settings, Predicate<Path> chosen)
            throws IOException {
        this(folder, list, new Listener() {}, settings, ToolProvider.getSystemJavaCompiler(), chosen);
    }

    BehaviourFolder(
            Path folder,
            BehaviourList list,
            Listener listener,
            ChildSettings settings,
            JavaCompiler compiler,
            Predicate<Path> chosen)
            throws IOException {
        this.chosen = chosen;
        this.folder = folder;
        this.list = list;
        this.listener = listener;
        files = new BehaviourFiles(
                new BehaviourCompiler(compiler, settings.hints()),
                settings,
                (file, fault) -> fail(BehaviourFiles.base(file), fault.line(), fault.text()));
        if (!Files.isDirectory(folder)) {
            throw new NotDirectoryException(folder.toString());
        }
        scan();
    }

    /** Replaces {@code System.out}: prints of a decision belong to the process, all others to the standard error. */
    public static void takePrints() {
        System.setOut(ProcessOutput.of(lines -> {
            if (BehaviourAnswer.isOpen()) {
                BehaviourAnswer.ask(new BehaviourRequest.Printed(lines));
            } else {
                System.err.print(lines);
            }
        }));
    }

    /**
     * Scans every 500 ms from now on, and starts children ahead.
     *
     * @param told receives the changes
     */
    public void start(Listener told) {
        listener = told;
        isLive = true;
        new TreeSet<>(names.keySet()).forEach(files::startAhead);
        thread.start();
    }

    /**
     * From now on processes have the numbers of the folder's {@code numbers.txt}, where new ones get one.
     *
     * @throws IOException if the file cannot be read or is damaged; the message names file and line
     */
    public void keepNumbers() throws IOException {
        numbers = new NumbersFile(folder);
        try {
            numbers.update(Set.of());
        } catch (SourceException damage) {
            throw new IOException(numbers.file() + ": line " + damage.line() + ": " + damage.getMessage(), damage);
        }
        number(Set.of());
    }

    /** @param added names beside those that have been loaded */
    private void number(Set<String> added) {
        if (numbers == null) {
            return;
        }
        SortedSet<String> all = new TreeSet<>(added);
        names.values().forEach(all::addAll);
        try {
            if (numbers.update(all)) {
                list.clearFault(NumbersFile.NAME);
            }
        } catch (SourceException damage) {
            fail(NumbersFile.NAME, damage.line(), damage.getMessage());
        } catch (IOException e) {
            fail(
                    NumbersFile.NAME,
                    0,
                    "cannot be read or written, new numbers hold until SimRobot ends: " + e.getMessage());
        }
        list.setNumbers(numbers.numbers());
    }

    /** Makes processes that begin from now on wait for each decision, so that a loaded machine changes no pose. */
    public void waitForDecisions() {
        files.waitForDecisions();
    }

    /**
     * Has Java processes decide on this thread, which simulates, from now on; others are waited for.
     *
     * @param ended told why a process ends the program, on another thread
     */
    public void callDirectly(Consumer<Decision.Failed> ended) {
        files.callDirectly(ended);
    }

    private void look() throws InterruptedException {
        while (!Thread.interrupted()) {
            Thread.sleep(PERIOD_MILLIS);
            try {
                scan();
            } catch (IOException | RuntimeException e) {
                LOG.log(Level.DEBUG, "{0} cannot be read now: {1}", folder, e.getMessage());
            }
        }
    }

    /** Scans once: compiles and loads changed files. */
    void scan() throws IOException {
        number(Set.of());
        Map<Path, Stamp> now = stamps();
        Map<Path, Stamp> before = seen;
        seen = now;
        if (now.equals(before)) {
            return;
        }
        for (Path gone : before.keySet()) {
            if (!now.containsKey(gone)) {
                forget(gone);
            }
        }
        boolean sourcesChanged = !ofSources(now).equals(ofSources(before));
        for (Path file : now.keySet()) {
            if (BehaviourFiles.isSource(file) ? sourcesChanged : !now.get(file).equals(before.get(file))) {
                load(file);
            }
        }
    }

    private static Map<Path, Stamp> ofSources(Map<Path, Stamp> stamps) {
        Map<Path, Stamp> sources = new TreeMap<>(stamps);
        sources.keySet().removeIf(file -> !BehaviourFiles.isSource(file));
        return sources;
    }

    private Map<Path, Stamp> stamps() throws IOException {
        Map<Path, Stamp> stamps = new TreeMap<>();
        try (Stream<Path> all = Files.list(folder)) {
            // an editor's lock may be a link to nothing
            for (Path file : all.filter(Files::isRegularFile).filter(chosen).toList()) {
                if (BehaviourFiles.mayBeProcess(file)) {
                    BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
                    stamps.put(file, new Stamp(attributes.lastModifiedTime().toMillis(), attributes.size()));
                }
            }
        }
        return stamps;
    }

    private void forget(Path file) {
        files.forget(file);
        Set<String> old = names.remove(file);
        list.clearFault(BehaviourFiles.base(file));
        if (old != null) {
            old.forEach(this::remove);
        }
    }

    private void remove(String name) {
        list.remove(name);
        listener.removed(name);
    }

    private void load(Path file) {
        try {
            Optional<BehaviourChild> before = files.child(file);
            List<BehaviourKind> kinds = files.kinds(file);
            list.clearFault(BehaviourFiles.base(file));
            Set<String> now = new HashSet<>();
            kinds.forEach(kind -> now.add(kind.text()));
            number(now);
            kinds.forEach(this::put);
            if (!before.equals(files.child(file))) {
                before.ifPresent(BehaviourChild::replace);
            }
            if (isLive) {
                files.startAhead(file);
            }
            if (!kinds.isEmpty()) {
                Set<String> old = names.put(file, now);
                if (old != null) {
                    old.stream().filter(name -> !now.contains(name)).forEach(this::remove);
                }
            }
        } catch (SourceException fault) {
            fail(BehaviourFiles.base(file), fault.line(), fault.getMessage());
        } catch (RuntimeException | LinkageError e) {
            // a file that fails leaves the others in place
            fail(BehaviourFiles.base(file), 0, "cannot be loaded: " + FaultPlace.text(e));
        }
    }

    private void fail(String name, int line, String text) {
        list.setFault(new BehaviourList.Fault(name, line, text));
        listener.failed(name, line, text);
    }

    private void put(BehaviourKind kind) {
        list.put(kind);
        listener.loaded(kind);
    }

    /** Stops scanning, and ends all children. */
    @Override
    public void close() {
        thread.interrupt();
        files.close();
    }
}
