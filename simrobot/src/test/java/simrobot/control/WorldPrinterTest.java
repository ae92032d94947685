package simrobot.control;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import simrobot.world.Area;
import simrobot.world.Box;
import simrobot.world.ForbiddenArea;
import simrobot.world.ForbiddenLine;
import simrobot.world.Goal;
import simrobot.world.Home;
import simrobot.world.Point;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.Treadmill;
import simrobot.world.World;

class WorldPrinterTest {
    @Test
    void linesPointsAndHomesAreInMillimetresAndDegrees() {
        World world = World.of(
                "w",
                List.of(
                        new Segment(-10, -0.1, 10, 2.0005),
                        new Point(0.3, -1.234),
                        new Box("Sofa", new Area(0, 0, 1, 2, Math.PI / 2)),
                        new Home("A, b", new Position(1, 1.7), Math.toRadians(90)),
                        new ForbiddenLine(new Segment(1, 2, 3, 4)),
                        new ForbiddenArea(new Area(1, 2, 3, 4, 0)),
                        new Treadmill(new Area(0, 0, 1, 1, 0), 0.5, Math.PI),
                        new Goal("Dock", "Charger", new Position(5, 6), 0)));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        WorldPrinter.print(world, new PrintStream(out, false, StandardCharsets.UTF_8));
        assertEquals(
                "line,-10000,-100,10000,2000.5\npoint,300,-1234\nhome,1000,1700,90,A, b\n"
                        + "box,0,0,1000,2000,90,Sofa\ngoal,5000,6000,0,Dock,Charger\n"
                        + "forbidden-line,1000,2000,3000,4000\nforbidden-area,1000,2000,3000,4000,0\n"
                        + "treadmill,0,0,1000,1000,0,500,180\n",
                out.toString(StandardCharsets.UTF_8));
    }
}
