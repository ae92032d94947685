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
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import simrobot.behaviour.Behaviour;
import simrobot.process.BehaviourKind;
import simrobot.process.BehaviourList;

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
    private static final String SOURCE = ".java";
    private static final String JAR = ".jar";

    /** A file's time of modification and size. */
    private record Stamp(long millis, long size) {}

    private final Path folder;
    private final BehaviourList list;
    private final BehaviourCompiler compiler;
    private final AtomicInteger threads = new AtomicInteger();
    private final Thread thread = new Thread(this::look, "behaviour folder");
    private Map<Path, Stamp> seen = Map.of();
    /** The classes of the last valid version, by file. */
    private final Map<Path, SortedMap<String, byte[]>> compiled = new HashMap<>();

    private final Map<Path, Set<String>> names = new HashMap<>();
    private volatile Listener listener;
    private volatile boolean patient;
    /** Null while numbers are not kept. */
    private NumbersFile numbers;

    /**
     * Scans the folder once.
     *
     * @throws NotDirectoryException if the path is no folder
     */
    public BehaviourFolder(Path folder, BehaviourList list, Listener listener) throws IOException {
        this(folder, list, listener, ToolProvider.getSystemJavaCompiler());
    }

    BehaviourFolder(Path folder, BehaviourList list, Listener listener, JavaCompiler compiler) throws IOException {
        this.folder = folder;
        this.list = list;
        this.listener = listener;
        this.compiler = new BehaviourCompiler(compiler);
        if (!Files.isDirectory(folder)) {
            throw new NotDirectoryException(folder.toString());
        }
        scan();
        thread.setDaemon(true);
    }

    /**
     * Scans every 500 ms from now on.
     *
     * @param told receives the changes
     */
    public void start(Listener told) {
        listener = told;
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

    /** Makes processes that begin from now on wait up to 1 s for each decision, instead of 50 ms. */
    public void waitForDecisions() {
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
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                if (isSource(file) || file.toString().endsWith(JAR)) {
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
            List<BehaviourKind> kinds = isSource(file) ? ofSource(file) : ofJar(file);
            list.clearFault(base(file));
            Set<String> now = new HashSet<>();
            kinds.forEach(kind -> now.add(kind.text()));
            number(now);
            kinds.forEach(this::put);
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

    private void fail(String name, int line, String text) {
        list.setFault(new BehaviourList.Fault(name, line, text));
        listener.failed(name, line, text);
    }

    private void put(BehaviourKind kind) {
        list.put(kind);
        listener.loaded(kind);
    }

    /** Empty if the classes are unchanged. */
    private List<BehaviourKind> ofSource(Path file) throws SourceException {
        SortedMap<String, byte[]> classes = new TreeMap<>(compiler.compile(file));
        if (isSame(classes, compiled.get(file))) {
            return List.of();
        }
        Class<? extends Behaviour> type = new LoadedClasses(classes).behaviour(base(file));
        BehaviourKind kind = kind(type, new FaultPlace(file.getFileName().toString()));
        compiled.put(file, classes);
        return List.of(kind);
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
            for (Class<? extends Behaviour> type : types) {
                kinds.add(kind(type, new FaultPlace(null)));
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

    private BehaviourKind kind(Class<? extends Behaviour> type, FaultPlace place) throws SourceException {
        String name = type.getSimpleName();
        if (BehaviourKind.BUILT_IN.stream().anyMatch(kind -> kind.text().equals(name))) {
            throw new SourceException(0, "the name " + name + " is taken, expected a class of another name");
        }
        return new BehaviourKind(
                name,
                around -> new BehaviourThread(
                        name + "-" + threads.incrementAndGet(),
                        () -> LoadedClasses.create(type),
                        place,
                        around.waitBudget(),
                        patient));
    }

    /** Stops scanning; running processes continue. */
    @Override
    public void close() {
        thread.interrupt();
    }
}
