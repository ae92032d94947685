package simrobot.app.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.ui.window.WindowMemory;
import simrobot.app.WorldFile;
import simrobot.world.World;

/**
 * The worlds chosen in the window, newest first, at most 8; remembered between runs with the windows. A window started
 * without {@code --world} shows the newest that still exists.
 */
public final class RecentWorlds {
    private static final int MOST = 8;
    private static final String LIST = "robot-worlds";

    /** Options of a run without a window, or started by the demo, a lesson or the centre. */
    private static final List<String> OF_OTHER_PROGRAMS =
            List.of("end-with-input", "console", "remember-as", "headless", "run", "print-world");

    private final Optional<WindowMemory> memory;
    private List<Path> files;
    private final Set<Path> unreadable = new HashSet<>();

    RecentWorlds(Optional<WindowMemory> memory) {
        this.memory = memory;
        files = memory.map(kept -> kept.list(LIST)).orElse(List.of()).stream()
                .flatMap(text -> path(text).stream())
                .limit(MOST)
                .toList();
    }

    /** Empty if the text is no path. */
    private static Optional<Path> path(String text) {
        try {
            return Optional.of(Path.of(text));
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }

    /** The user's worlds; empty if nothing is remembered. */
    public static RecentWorlds of(Arguments arguments) {
        return new RecentWorlds(WindowMemory.of(arguments));
    }

    /**
     * The initial world.
     *
     * @param file empty for the demo's world
     */
    public record Start(Optional<Path> file, World world) {}

    /** {@code --world}; else the newest readable one, if the user, not another program, started a window. */
    public Start start(Arguments given) throws UsageException, IOException {
        OptionalDouble resolutionMeters = WorldFile.resolution(given);
        Optional<Path> named = given.path("world");
        boolean isOfUser = OF_OTHER_PROGRAMS.stream().noneMatch(given::has);
        if (isOfUser) {
            named.map(Optional::of).map(WorldFile::find).filter(Files::exists).ifPresent(this::add);
        }
        for (Path file : named.isEmpty() && isOfUser ? files() : List.<Path>of()) {
            try {
                return new Start(Optional.of(file), WorldFile.read(Optional.of(file), resolutionMeters));
            } catch (IOException changed) {
                leaveOut(file);
            }
        }
        return new Start(named, WorldFile.read(named, resolutionMeters));
    }

    /** The worlds that still exist; callable on any thread. */
    public synchronized List<Path> files() {
        return files.stream()
                .filter(file -> Files.isReadable(file) && !unreadable.contains(file))
                .toList();
    }

    /** Removes an unreadable world from this run's list until it is added again. */
    synchronized void leaveOut(Path world) {
        unreadable.add(world.toAbsolutePath().normalize());
    }

    /** Moves a world to the front, unless it is built in. */
    public synchronized void add(Path world) {
        Path file = world.toAbsolutePath().normalize();
        unreadable.remove(file);
        boolean isFile = Files.isReadable(file);
        if (isFile && (files.isEmpty() || !files.get(0).equals(file))) {
            List<Path> next = new ArrayList<>(files);
            next.remove(file);
            next.add(0, file);
            files = List.copyOf(next.subList(0, Math.min(MOST, next.size())));
            memory.ifPresent(kept ->
                    kept.keepList(LIST, files.stream().map(Path::toString).toList()));
        }
    }
}
