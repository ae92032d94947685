package simrobot.source;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.stream.Stream;
import simgsm.file.Utf8Text;
import simrobot.behaviour.Behaviour;
import simrobot.process.BehaviourKind;
import simrobot.process.Decision;
import simrobot.source.child.FaultPlace;
import simrobot.source.child.LoadedClasses;

/** Makes processes from files: compiles and loads them, and keeps the child of each. */
final class BehaviourFiles {
    /** Each child takes memory: those of further files start when a robot begins one. */
    private static final int MOST_STARTED_AHEAD = 8;

    private static final String SOURCE = ".java";
    private static final String JAR = ".jar";
    private static final String PYTHON = ".py";

    private final BehaviourCompiler compiler;
    private final ChildSettings settings;
    private final BiConsumer<Path, Decision.Failed> failed;
    /** The classes of the last valid version, by file. */
    private final Map<Path, SortedMap<String, byte[]>> compiled = new HashMap<>();

    private final Map<Path, BehaviourChild> children = new ConcurrentHashMap<>();
    private volatile boolean patient;
    /** Null while children decide. */
    private DirectCalls direct;

    /** @param failed told why a file's child cannot run, on any thread */
    BehaviourFiles(BehaviourCompiler compiler, ChildSettings settings, BiConsumer<Path, Decision.Failed> failed) {
        this.compiler = compiler;
        this.settings = settings;
        this.failed = failed;
    }

    /** True for a name that ends in .java, .jar or .py. */
    static boolean mayBeProcess(Path file) {
        return Stream.of(SOURCE, JAR, PYTHON).anyMatch(file.toString()::endsWith);
    }

    static boolean isSource(Path file) {
        return file.toString().endsWith(SOURCE);
    }

    /** The name without its end. */
    static String base(Path file) {
        String name = file.getFileName().toString();
        return name.substring(0, name.lastIndexOf('.'));
    }

    void waitForDecisions() {
        patient = true;
    }

    void callDirectly(Consumer<Decision.Failed> ended) {
        direct = new DirectCalls(ended);
        patient = true;
    }

    /** The child of the newest version. */
    Optional<BehaviourChild> child(Path file) {
        return Optional.ofNullable(children.get(file));
    }

    void forget(Path file) {
        compiled.remove(file);
        child(file).ifPresent(BehaviourChild::close);
        children.remove(file);
    }

    /** Starts the child of a file, so that the first decision does not wait for it; not if many run. */
    void startAhead(Path file) {
        boolean isPlace =
                children.values().stream().filter(BehaviourChild::isRunning).count() < MOST_STARTED_AHEAD;
        if (isPlace) {
            try {
                children.get(file).start();
            } catch (IOException e) {
                failed.accept(file, new Decision.Failed(0, settings.hints().with(e.getMessage(), "start")));
            }
        }
    }

    /**
     * Returns the processes of a file; none if its compiled classes are unchanged.
     *
     * @throws SourceException if it makes none
     */
    List<BehaviourKind> kinds(Path file) throws SourceException {
        if (isSource(file)) {
            return ofSource(file);
        }
        return file.toString().endsWith(JAR) ? ofJar(file) : ofPython(file);
    }

    private List<BehaviourKind> ofPython(Path file) throws SourceException {
        if (!base(file).matches("\\w+")) {
            throw new SourceException(0, "expected a file name of letters, digits and _, found " + file.getFileName());
        }
        ChildFile python = ChildFile.ofPython(base(file), file.toAbsolutePath(), source(file), settings);
        BehaviourChild child = new BehaviourChild(python, fault -> failed.accept(file, fault));
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
        BehaviourChild child =
                new BehaviourChild(ChildFile.ofSource(base(file), classes, lines, settings), fault -> {});
        // a halt would end SimRobot without an outcome
        FaultPlace place = LoadedClasses.mention(classes, "halt")
                ? null
                : new FaultPlace(file.getFileName().toString());
        BehaviourKind kind = kind(type, child, place);
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
            ClassLoader loader = new URLClassLoader(
                    LoadedClasses.NAME, new URL[] {copy.toUri().toURL()}, Behaviour.class.getClassLoader());
            List<? extends Class<? extends Behaviour>> types = ServiceLoader.load(Behaviour.class, loader).stream()
                    .map(ServiceLoader.Provider::type)
                    .filter(type -> type.getClassLoader() == loader)
                    .toList();
            BehaviourChild child = new BehaviourChild(ChildFile.ofJar(base(jar), copy, settings), fault -> {});
            for (Class<? extends Behaviour> type : types) {
                kinds.add(kind(type, child, null));
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

    /** @param place of faults in decisions that are called directly; null if always the child decides */
    private BehaviourKind kind(Class<? extends Behaviour> type, BehaviourChild child, FaultPlace place)
            throws SourceException {
        String name = type.getSimpleName();
        requireFree(name);
        return new BehaviourKind(
                name,
                around -> direct == null || place == null
                        ? child.ofRobot(type.getName(), around.waitBudget(), patient)
                        : direct.ofRobot(type, child.file(), place));
    }

    private static void requireFree(String name) throws SourceException {
        if (BehaviourKind.BUILT_IN.stream().anyMatch(kind -> kind.text().equals(name))) {
            throw new SourceException(0, "the name " + name + " is taken, expected a class of another name");
        }
    }

    /** Ends all children. */
    void close() {
        children.values().forEach(BehaviourChild::close);
        if (direct != null) {
            direct.close();
        }
    }
}
