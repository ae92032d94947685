package simrobot.control;

import java.io.PrintStream;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import simrobot.world.Area;
import simrobot.world.World;

/** Prints a loaded world for {@code --print-world}, in the files' units: millimetres and degrees. */
public final class WorldPrinter {
    private WorldPrinter() {}

    public static void print(World world, PrintStream out) {
        world.segments()
                .forEach(line -> row(
                        out,
                        "line",
                        millimeters(line.x1Meters()),
                        millimeters(line.y1Meters()),
                        millimeters(line.x2Meters()),
                        millimeters(line.y2Meters())));
        world.points().forEach(point -> row(out, "point", millimeters(point.xMeters()), millimeters(point.yMeters())));
        world.homes()
                .forEach(home -> row(
                        out,
                        "home",
                        millimeters(home.position().xMeters()),
                        millimeters(home.position().yMeters()),
                        plain(Math.toDegrees(home.headingRadians())),
                        home.name()));
        world.boxes().forEach(box -> area(out, "box", box.area(), box.name()));
        world.goals()
                .forEach(goal -> row(
                        out,
                        "goal",
                        millimeters(goal.position().xMeters()),
                        millimeters(goal.position().yMeters()),
                        plain(Math.toDegrees(goal.headingRadians())),
                        goal.type(),
                        goal.name()));
        world.forbiddenLines()
                .forEach(line -> row(
                        out,
                        "forbidden-line",
                        millimeters(line.x1Meters()),
                        millimeters(line.y1Meters()),
                        millimeters(line.x2Meters()),
                        millimeters(line.y2Meters())));
        world.forbiddenAreas().forEach(area -> area(out, "forbidden-area", area));
        world.treadmills()
                .forEach(belt -> area(
                        out,
                        "treadmill",
                        belt.area(),
                        millimeters(belt.speedMetersPerSecond()),
                        plain(Math.toDegrees(belt.directionRadians()))));
        out.flush();
    }

    /** The corners before the rotation, the rotation in degrees, and more. */
    private static void area(PrintStream out, String kind, Area area, String... more) {
        List<String> fields = new ArrayList<>(List.of(
                kind,
                millimeters(area.minXMeters()),
                millimeters(area.minYMeters()),
                millimeters(area.maxXMeters()),
                millimeters(area.maxYMeters()),
                plain(Math.toDegrees(area.rotationRadians()))));
        fields.addAll(List.of(more));
        row(out, fields.toArray(String[]::new));
    }

    private static void row(PrintStream out, String... fields) {
        out.print(String.join(",", fields) + "\n");
    }

    private static String millimeters(double meters) {
        return plain(meters * 1000);
    }

    /** Formats without trailing zeros, rounded against the error of the conversion to SI and back. */
    private static String plain(double value) {
        BigDecimal rounded = BigDecimal.valueOf(value).setScale(4, RoundingMode.HALF_EVEN);
        return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    }
}
