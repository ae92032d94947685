package simrobot.ui.panel;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import simgsm.console.TextBundle;

/** The worlds shipped with the program, in the order of a course, with a line on each one's purpose. */
final class ShippedWorlds {
    static final List<String> NAMES =
            List.of("demo.map", "office.map", "corridor.map", "maze.map", "treadmill.map", "empty.map");

    /** Path relative to the program's folder or its parent. */
    static final Path FOLDER = Path.of("worlds");

    private ShippedWorlds() {}

    /** A world's purpose; empty for any other file. */
    static Optional<String> about(TextBundle texts, Path file) {
        String name = String.valueOf(file.getFileName());
        return NAMES.contains(name) && (!Files.exists(file) || isAsShipped(file, name))
                ? Optional.of(texts.of("world.about." + name.replace(".map", "")))
                : Optional.empty();
    }

    private static boolean isAsShipped(Path file, String name) {
        try (InputStream shipped = ShippedWorlds.class.getResourceAsStream("/simrobot/world-files/" + name)) {
            return shipped != null && Arrays.equals(shipped.readAllBytes(), Files.readAllBytes(file));
        } catch (IOException unreadable) {
            return false;
        }
    }
}
