package simrobot.world;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.stream.Stream;

/**
 * What was loaded, a line each, in millimetres and degrees: {@code line,x1,y1,x2,y2}, {@code point,x,y},
 * {@code home,x,y,heading,name}, then what our reader knows beyond those: {@code box,x1,y1,x2,y2,rotation,name} and
 * {@code treadmill,x1,y1,x2,y2,speed,direction}.
 */
public final class WorldListing {
    private WorldListing() {}

    public static Stream<String> lines(World world) {
        return Stream.of(
                        world.segments().stream().map(WorldListing::line),
                        world.points().stream().map(p -> row("point", mm(p.xMeters()), mm(p.yMeters()))),
                        world.homes().stream().map(WorldListing::home),
                        world.boxes().stream().map(WorldListing::box),
                        world.treadmills().stream().map(WorldListing::treadmill))
                .flatMap(lines -> lines);
    }

    private static String line(Segment wall) {
        return row("line", mm(wall.x1Meters()), mm(wall.y1Meters()), mm(wall.x2Meters()), mm(wall.y2Meters()));
    }

    private static String home(Home home) {
        Position at = home.position();
        return row("home", mm(at.xMeters()), mm(at.yMeters()), degrees(home.headingRadians()), home.name());
    }

    private static String box(Box box) {
        return row("box", corners(box.area()), degrees(box.area().rotationRadians()), box.name());
    }

    private static String treadmill(Treadmill belt) {
        return row(
                "treadmill", corners(belt.area()), mm(belt.speedMetersPerSecond()), degrees(belt.directionRadians()));
    }

    private static String corners(Area area) {
        return String.join(
                ",", mm(area.minXMeters()), mm(area.minYMeters()), mm(area.maxXMeters()), mm(area.maxYMeters()));
    }

    private static String row(String... values) {
        return String.join(",", List.of(values));
    }

    private static String mm(double meters) {
        return number(meters * 1000, 3);
    }

    private static String degrees(double radians) {
        return number(Math.toDegrees(radians), 6);
    }

    /** Without trailing zeros, so that whole millimetres come out as they went in. */
    private static String number(double value, int decimals) {
        BigDecimal rounded = BigDecimal.valueOf(value)
                .setScale(decimals, RoundingMode.HALF_EVEN)
                .stripTrailingZeros();
        return rounded.signum() == 0 ? "0" : rounded.toPlainString();
    }
}
