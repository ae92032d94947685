package simrobot.app.window;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WorldFileWatchTest {
    @TempDir
    Path folder;

    @Test
    void aChangedFileIsNoticedUntilItIsTakenOver() throws Exception {
        Path file = Files.writeString(folder.resolve("w.map"), "2D-Map\n");
        Files.setLastModifiedTime(file, FileTime.fromMillis(1_000_000));
        WorldFileWatch watch = new WorldFileWatch(Runnable::run, file);
        watch.look();
        assertFalse(watch.hasChanged());
        Files.setLastModifiedTime(file, FileTime.fromMillis(2_000_000));
        watch.look();
        assertTrue(watch.hasChanged());
        watch.setCurrent(file);
        assertFalse(watch.hasChanged());
    }

    @Test
    void aFileThatIsGoneHasNotChanged() throws Exception {
        Path file = Files.writeString(folder.resolve("w.map"), "2D-Map\n");
        WorldFileWatch watch = new WorldFileWatch(Runnable::run, file);
        Files.delete(file);
        watch.look();
        assertFalse(watch.hasChanged());
    }
}
