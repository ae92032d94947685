package simrobot.app.window;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Queue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simrobot.world.World;

class DraftFilesTest {
    @TempDir
    private Path folder;

    private final DraftFiles drafts = new DraftFiles();
    private final Queue<Runnable> waiting = new ArrayDeque<>();

    private void work() {
        while (!waiting.isEmpty()) {
            waiting.remove().run();
        }
    }

    @Test
    void aDraftThatIsDroppedBeforeItIsWrittenIsNotWrittenAnyMore() {
        Path file = folder.resolve(".a.map.draft");
        drafts.keep(World.bare(), file, waiting::add);
        drafts.drop(file);
        work();
        assertFalse(Files.exists(file));
    }

    @Test
    void aDraftIsThereUntilItIsDroppedAndTheNextOneIsWritten() {
        Path file = folder.resolve(".a.map.draft");
        drafts.keep(World.bare(), file, waiting::add);
        work();
        assertTrue(Files.exists(file));
        drafts.drop(file);
        assertFalse(Files.exists(file));
        drafts.keep(World.bare(), file, waiting::add);
        work();
        assertTrue(Files.exists(file));
    }
}
