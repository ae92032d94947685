package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simrobot.world.Home;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;

class WorldPrinterTest {
    @Test
    void linesPointsAndHomesAreInMillimetresAndDegrees() {
        World world = new World(
                "w",
                List.of(new Segment(-10, -0.1, 10, 2.0005)),
                List.of(new Position(0.3, -1.234)),
                0.02,
                List.of(),
                List.of(new Home("A, b", new Position(1, 1.7), Math.toRadians(90), Optional.empty())),
                List.of(),
                List.of(),
                List.of(),
                List.of());
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        WorldPrinter.print(world, new PrintStream(out, false, StandardCharsets.UTF_8));
        assertEquals(
                "line,-10000,-100,10000,2000.5\npoint,300,-1234\nhome,1000,1700,90,A, b\n",
                out.toString(StandardCharsets.UTF_8));
    }
}
