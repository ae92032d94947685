package simrobot.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import simgsm.console.Arguments;
import simgsm.console.UsageException;
import simgsm.ui.window.WindowMemory;
import simrobot.bitmap.BitmapWorld;

/**
 * The worlds that the user of the window has chosen, the newest first, at most 8; kept from run to run where windows are
 * remembered. A window that is started without {@code --world} shows the newest one that is still there.
 */
public final class RecentWorlds {
    private static final int MOST = 8;
    private static final String LIST = "robot-worlds";

    /** Options of a SimRobot that the demo, a lesson or the centre has started, or without a window. */
    private static final List<String> OF_OTHER_PROGRAMS =
            List.of("end-with-input", "console", "remember-as", "headless", "run", "print-world");

    private final Optional<WindowMemory> memory;
    private List<Path> files;

    RecentWorlds(Optional<WindowMemory> memory) {
        this.memory = memory;
        files = memory.map(kept -> kept.list(LIST)).orElse(List.of()).stream()
                .flatMap(text -> path(text).stream())
                .limit(MOST)
                .toList();
    }

    /** Empty for a text that something else has written. */
    private static Optional<Path> path(String text) {
        try {
            return Optional.of(Path.of(text));
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }

    /** Those of the user; empty where nothing is remembered. */
    public static RecentWorlds of(Arguments arguments) {
        return new RecentWorlds(WindowMemory.of(arguments));
    }

    /** The newest world that can still be read. */
    synchronized Optional<Path> newest(OptionalDouble resolutionMeters) {
        return files.stream().filter(file -> isWorld(file, resolutionMeters)).findFirst();
    }

    private static boolean isWorld(Path file, OptionalDouble resolutionMeters) {
        try {
            return Files.isReadable(file) && BitmapWorld.read(file, resolutionMeters) != null;
        } catch (IOException changed) {
            return false;
        }
    }

    /**
     * The world to begin with: {@code --world}; else the newest one, if the user has started a window and no other program has.
     *
     * @return empty for the demo's world
     */
    public Optional<Path> first(Arguments given) throws UsageException {
        Optional<Path> named = given.path("world");
        boolean isOfUser = OF_OTHER_PROGRAMS.stream().noneMatch(given::has);
        if (isOfUser) {
            named.map(Optional::of).map(WorldFile::find).filter(Files::exists).ifPresent(this::add);
        }
        return named.isEmpty() && isOfUser ? newest(WorldFile.resolution(given)) : named;
    }

    /** Those that are still there; any thread may ask. */
    public synchronized List<Path> files() {
        return files.stream().filter(Files::isReadable).toList();
    }

    /** Puts a world first, unless it is one that the program carries itself. */
    public synchronized void add(Path world) {
        Path file = world.toAbsolutePath().normalize();
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
