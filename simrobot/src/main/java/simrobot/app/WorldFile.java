package simrobot.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import simgsm.console.Arguments;
import simgsm.console.ProgramFolder;
import simgsm.console.UsageException;
import simrobot.bitmap.BitmapWorld;
import simrobot.world.World;
import simrobot.world.WorldReader;

/**
 * Finds a world file: as named, in {@code worlds/}, upward from the folder of the jar or the image, with or without
 * {@code worlds/}, or among the built-in worlds.
 */
public final class WorldFile {
    private static final Path FOLDER = Path.of("worlds");
    private static final String RESOURCES = "/simrobot/world-files/";
    private static final Path DEFAULT = FOLDER.resolve("demo.map");

    private WorldFile() {}

    /** @param name empty for the demo's world */
    public static World read(Optional<Path> name) throws IOException {
        return read(name, OptionalDouble.empty());
    }

    /** @param resolutionMeters the width of a pixel of a picture */
    public static World read(Optional<Path> name, OptionalDouble resolutionMeters) throws IOException {
        Path place = find(name);
        if (Files.isDirectory(place)) {
            throw new IOException(place + ": expected a world file, found a folder");
        }
        if (Files.exists(place)) {
            return BitmapWorld.read(place, resolutionMeters);
        }
        byte[] content = ProgramFolder.carried(WorldFile.class, FOLDER, place, RESOURCES)
                .orElseThrow(() -> new NoSuchFileException(place.toString()));
        return WorldReader.read(place, content);
    }

    /** The option --resolution: metres per pixel. */
    public static OptionalDouble resolution(Arguments arguments) throws UsageException {
        return arguments.has("resolution")
                ? OptionalDouble.of(arguments.number("resolution", 0, 1e-4, 10))
                : OptionalDouble.empty();
    }

    /** The path of the world's file; as named if it is not found. */
    public static Path find(Optional<Path> name) {
        return ProgramFolder.find(WorldFile.class, FOLDER, name.orElse(DEFAULT));
    }
}
