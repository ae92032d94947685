package simrobot.world;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;
import simgsm.file.FileReplacement;

/**
 * Writes a world as ARIA's {@code .map}, millimetres and degrees, without loss: {@link MapReader} restores every
 * coordinate to the last bit.
 */
public final class MapWriter {
    private final StringBuilder out = new StringBuilder();
    private final World world;

    private MapWriter(World world) {
        this.world = world;
    }

    /** The file's text, lines ended by LF. */
    public static String text(World world) {
        MapWriter writer = new MapWriter(world);
        writer.headers();
        writer.cairns();
        writer.lines();
        return writer.out.toString();
    }

    /**
     * Saves the world as a {@code .map}, whole or not at all: a full disk leaves the old file.
     *
     * @throws IOException saying which file cannot be written, and why
     */
    public static void save(World world, Path file) throws IOException {
        FileReplacement.write(file, text(world).getBytes(StandardCharsets.UTF_8));
    }

    private void row(String... words) {
        out.append(String.join(" ", words)).append('\n');
    }

    // ---- headers ---------------------------------------------------------------------------------------------------

    private void headers() {
        row("2D-Map");
        BoundingBox walls = new BoundingBox();
        world.items(Segment.class).forEach(walls::add);
        bounds("LineMinPos:", "LineMaxPos:", walls);
        row("NumLines:", String.valueOf(world.items(Segment.class).size()));
        row("LinesAreSorted: false");
        BoundingBox points = new BoundingBox();
        world.items(Point.class).forEach(points::add);
        bounds("MinPos:", "MaxPos:", points);
        row("NumPoints:", String.valueOf(world.items(Point.class).size()));
        row("PointsAreSorted: false");
        row("Resolution:", millimeters(world.pointDiameterMeters()));
    }

    private void bounds(String from, String to, BoundingBox bounds) {
        Area area = bounds.or(new Area(0, 0, 0, 0, 0));
        row(from, millimeters(area.minXMeters()), millimeters(area.minYMeters()));
        row(to, millimeters(area.maxXMeters()), millimeters(area.maxYMeters()));
    }

    // ---- cairns ----------------------------------------------------------------------------------------------------

    private void cairns() {
        world.items().forEach(item -> item.kind().cairn(item).ifPresent(cairn -> row(cairn.line())));
    }

    // ---- walls and points ------------------------------------------------------------------------------------------

    private void lines() {
        row("LINES");
        world.items(Segment.class).forEach(wall -> row(millimeters(wall.ends())));
        row("DATA");
        world.items(Point.class).forEach(point -> row(millimeters(point.xMeters(), point.yMeters())));
    }

    /** The shortest decimal that reads as the same number of metres. */
    static String millimeters(double meters) {
        return ItemField.plain(BigDecimal.valueOf(meters).movePointRight(3));
    }

    /** Several numbers, separated by blanks. */
    static String millimeters(double... meters) {
        return Arrays.stream(meters).mapToObj(MapWriter::millimeters).collect(Collectors.joining(" "));
    }

    /** Degrees rounded to 1e-6 if they read as the same radians, else with all digits. */
    static String degrees(double radians) {
        double exact = Math.toDegrees(radians);
        BigDecimal round = BigDecimal.valueOf(Math.rint(exact * 1e6)).movePointLeft(6);
        if (Math.toRadians(round.doubleValue()) == radians) {
            return ItemField.plain(round);
        }
        double degrees = exact;
        for (int i = 0; i < 4 && Math.toRadians(degrees) != radians; i++) {
            degrees = Math.toRadians(degrees) < radians ? Math.nextUp(degrees) : Math.nextDown(degrees);
        }
        return ItemField.plain(BigDecimal.valueOf(degrees));
    }
}
