package simrobot.source;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import simgsm.file.Utf8Text;
import simrobot.behaviour.BehaviourAnswer;
import simrobot.behaviour.Behaviour;
import simrobot.behaviour.BehaviourRequest;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;
import simrobot.process.Decision;
import simrobot.source.child.FaultPlace;
import simrobot.source.child.LoadedClasses;
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
    /** Each child takes memory: those of further files start when a robot begins one. */
    private static final int MOST_STARTED_AHEAD = 8;

    private static final String SOURCE = ".java";
    private static final String JAR = ".jar";
    private static final String PYTHON = ".py";

    /** A file's time of modification and size. */
    private record Stamp(long millis, long size) {}

    private final Path folder;
    private final BehaviourList list;
    private final BehaviourCompiler compiler;
    private final ChildSettings settings;
    private final Predicate<Path> chosen;
    private final Thread thread = new Thread(this::look, "behaviour folder");
    private Map<Path, Stamp> seen = Map.of();
    /** The classes of the last valid version, by file. */
    private final Map<Path, SortedMap<String, byte[]>> compiled = new HashMap<>();

    private final Map<Path, Set<String>> names = new HashMap<>();
    private final Map<Path, BehaviourChild> children = new ConcurrentHashMap<>();
    private volatile Listener listener;
    private volatile boolean patient;
    /** Null while children decide. */
    private DirectCalls direct;

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
        this.settings = settings;
        this.chosen = chosen;
        this.folder = folder;
        this.list = list;
        this.listener = listener;
        this.compiler = new BehaviourCompiler(compiler, settings.hints());
        if (!Files.isDirectory(folder)) {
            throw new NotDirectoryException(folder.toString());
        }
        scan();
        thread.setDaemon(true);
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
        children.keySet().stream().sorted().toList().forEach(this::startAhead);
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
            fail(NumbersFile.NAME, 0, "cannot be read or written, new numbers hold until SimRobot ends: " + e.getMessage());
        }
        list.setNumbers(numbers.numbers());
    }

    /** Makes processes that begin from now on wait for each decision, so that a loaded machine changes no pose. */
    void waitForDecisions() {
        patient = true;
    }

    /**
     * Has Java processes decide on this thread, which simulates, from now on; others are waited for.
     *
     * @param ended told why a process ends the program, on another thread
     */
    public void callDirectly(Consumer<Decision.Failed> ended) {
        direct = new DirectCalls(ended);
        patient = true;
    }

    private void look() {
        try {
            while (!Thread.interrupted()) {
                Thread.sleep(PERIOD_MILLIS);
                try {
                    scan();
                } catch (IOException | RuntimeException e) {
                    LOG.log(Level.DEBUG, "{0} cannot be read now: {1}", folder, e.getMessage());
                }
            }
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
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
            if (isSource(file) ? sourcesChanged : !now.get(file).equals(before.get(file))) {
                load(file);
            }
        }
    }

    private static Map<Path, Stamp> ofSources(Map<Path, Stamp> stamps) {
        Map<Path, Stamp> sources = new TreeMap<>(stamps);
        sources.keySet().removeIf(file -> !isSource(file));
        return sources;
    }

    private Map<Path, Stamp> stamps() throws IOException {
        Map<Path, Stamp> stamps = new TreeMap<>();
        try (Stream<Path> files = Files.list(folder)) {
            // an editor's lock may be a link to nothing
            for (Path file : files.filter(Files::isRegularFile).filter(chosen).toList()) {
                if (Stream.of(SOURCE, JAR, PYTHON).anyMatch(file.toString()::endsWith)) {
                    BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
                    stamps.put(file, new Stamp(attributes.lastModifiedTime().toMillis(), attributes.size()));
                }
            }
        }
        return stamps;
    }

    private static boolean isSource(Path file) {
        return file.toString().endsWith(SOURCE);
    }

    private static String base(Path file) {
        String name = file.getFileName().toString();
        return name.substring(0, name.lastIndexOf('.'));
    }

    private void forget(Path file) {
        compiled.remove(file);
        BehaviourChild child = children.remove(file);
        if (child != null) {
            child.close();
        }
        Set<String> old = names.remove(file);
        list.clearFault(base(file));
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
            BehaviourChild before = children.get(file);
            List<BehaviourKind> kinds = kinds(file);
            list.clearFault(base(file));
            Set<String> now = new HashSet<>();
            kinds.forEach(kind -> now.add(kind.text()));
            number(now);
            kinds.forEach(this::put);
            if (before != null && children.get(file) != before) {
                before.replace();
            }
            startAhead(file);
            if (!kinds.isEmpty()) {
                Set<String> old = names.put(file, now);
                if (old != null) {
                    old.stream().filter(name -> !now.contains(name)).forEach(this::remove);
                }
            }
        } catch (SourceException fault) {
            fail(base(file), fault.line(), fault.getMessage());
        } catch (RuntimeException | LinkageError e) {
            // a file that fails leaves the others in place
            fail(base(file), 0, "cannot be loaded: " + FaultPlace.text(e));
        }
    }

    private void startAhead(Path file) {
        boolean isPlace = children.values().stream().filter(BehaviourChild::isRunning).count() < MOST_STARTED_AHEAD;
        if (isLive && isPlace) {
            try {
                children.get(file).start();
            } catch (IOException e) {
                fail(base(file), 0, e.getMessage());
            }
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

    private List<BehaviourKind> kinds(Path file) throws SourceException {
        if (isSource(file)) {
            return ofSource(file);
        }
        return file.toString().endsWith(JAR) ? ofJar(file) : ofPython(file);
    }

    private List<BehaviourKind> ofPython(Path file) throws SourceException {
        ChildFile python = ChildFile.ofPython(base(file), file.toAbsolutePath(), source(file), settings);
        BehaviourChild child = new BehaviourChild(python, fault -> fail(base(file), fault.line(), fault.text()));
        requireFree(base(file));
        children.put(file, child);
        return List.of(new BehaviourKind(base(file), around -> child.ofRobot("", around.waitBudget(), patient)));
    }

    /** Empty if the classes are unchanged. */
    private List<BehaviourKind> ofSource(Path file) throws SourceException {
        String source = source(file);
        SourceLines lines = SourceLines.of(source);
        SortedMap<String, byte[]> classes = new TreeMap<>(compiler.compile(file, source));
        if (isSame(classes, compiled.get(file))) {
            return List.of();
        }
        Class<? extends Behaviour> type = new LoadedClasses(classes)
                .behaviour(base(file))
                .orElseThrow(() -> new SourceException(
                        lines.likely("process"),
                        settings.hints()
                                .with(
                                        "no class that is a process, expected: public class " + base(file)
                                                + " implements simrobot.behaviour.Behaviour, with a constructor without"
                                                + " parameters",
                                        "process")));
        BehaviourChild child = new BehaviourChild(ChildFile.ofSource(base(file), classes, lines, settings), fault -> {});
        BehaviourKind kind = kind(type, child, new FaultPlace(file.getFileName().toString()));
        compiled.put(file, classes);
        children.put(file, child);
        return List.of(kind);
    }

    private static String source(Path file) throws SourceException {
        try {
            return Utf8Text.read(file);
        } catch (IOException e) {
            throw new SourceException(0, "cannot be read: " + e.getMessage());
        }
    }

    private static boolean isSame(SortedMap<String, byte[]> classes, SortedMap<String, byte[]> before) {
        return before != null
                && classes.keySet().equals(before.keySet())
                && classes.keySet().stream().allMatch(name -> Arrays.equals(classes.get(name), before.get(name)));
    }

    /** Loads a copy, so that the jar itself can be replaced. */
    private List<BehaviourKind> ofJar(Path jar) throws SourceException {
        List<BehaviourKind> kinds = new ArrayList<>();
        try {
            Path copy = Files.createTempFile("behaviours", JAR);
            copy.toFile().deleteOnExit();
            Files.copy(jar, copy, StandardCopyOption.REPLACE_EXISTING);
            ClassLoader loader = new URLClassLoader(new URL[] {copy.toUri().toURL()}, Behaviour.class.getClassLoader());
            List<? extends Class<? extends Behaviour>> types = ServiceLoader.load(Behaviour.class, loader).stream()
                    .map(ServiceLoader.Provider::type)
                    .filter(type -> type.getClassLoader() == loader)
                    .toList();
            BehaviourChild child = new BehaviourChild(ChildFile.ofJar(base(jar), copy, settings), fault -> {});
            for (Class<? extends Behaviour> type : types) {
                kinds.add(kind(type, child, new FaultPlace(null)));
            }
            if (!kinds.isEmpty()) {
                children.put(jar, child);
            }
        } catch (IOException e) {
            throw new SourceException(0, "cannot be read: " + e.getMessage());
        } catch (ServiceConfigurationError | LinkageError e) {
            throw new SourceException(0, FaultPlace.text(e));
        }
        if (kinds.isEmpty()) {
            throw new SourceException(
                    0, "names no process, expected META-INF/services/simrobot.behaviour.Behaviour with a class's name");
        }
        return kinds;
    }

    private BehaviourKind kind(Class<? extends Behaviour> type, BehaviourChild child, FaultPlace place)
            throws SourceException {
        String name = type.getSimpleName();
        requireFree(name);
        return new BehaviourKind(name, around -> direct == null
                ? child.ofRobot(type.getName(), around.waitBudget(), patient)
                : direct.ofRobot(type, child.file(), place));
    }

    private static void requireFree(String name) throws SourceException {
        if (BehaviourKind.BUILT_IN.stream().anyMatch(kind -> kind.text().equals(name))) {
            throw new SourceException(0, "the name " + name + " is taken, expected a class of another name");
        }
    }

    /** Stops scanning, and ends all children. */
    @Override
    public void close() {
        thread.interrupt();
        children.values().forEach(BehaviourChild::close);
        if (direct != null) {
            direct.close();
        }
    }
}
