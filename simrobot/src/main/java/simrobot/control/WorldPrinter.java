package simrobot.control;

import java.io.PrintStream;
import java.math.BigDecimal;
import java.math.RoundingMode;
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
        out.flush();
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
