package simrobot.control;

import java.io.PrintStream;
import simrobot.world.World;

/** Prints a loaded world for {@code --print-world}, in the files' units: millimetres and degrees. */
public final class WorldPrinter {
    private WorldPrinter() {}

    /** A row for each item: its kind's word, then its fields. */
    public static void print(World world, PrintStream out) {
        world.items().forEach(item -> out.print(String.join(",", item.kind().printed(item)) + "\n"));
        out.flush();
    }
}
