package simrobot.control;

import java.io.IOException;
import java.nio.file.Path;
import simrobot.world.World;

/** Where worlds come from. */
public interface Worlds {
    /** @throws IOException when the file cannot be read or holds no world */
    World read(Path file) throws IOException;
}
