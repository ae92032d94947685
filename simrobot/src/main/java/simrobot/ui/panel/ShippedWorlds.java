package simrobot.ui.panel;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import simgsm.console.TextBundle;

/** The worlds that come with the program, in the order in which a class meets them, with a line on what each is for. */
final class ShippedWorlds {
    static final List<String> NAMES =
            List.of("demo.map", "office.map", "corridor.map", "maze.map", "treadmill.map", "empty.map");

    /** Below the program's own folder or one above it. */
    static final Path FOLDER = Path.of("worlds");

    private ShippedWorlds() {}

    /** What a world is for; empty for a file that does not hold one of these worlds. */
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
