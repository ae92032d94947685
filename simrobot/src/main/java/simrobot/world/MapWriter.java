package simrobot.world;

import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import simgsm.file.FileReplacement;

/**
 * Writes a world as ARIA's {@code .map}, millimetres and degrees. {@link MapReader} reads the same world from it, to the last
 * bit of every coordinate.
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
        world.segments().forEach(walls::add);
        bounds("LineMinPos:", "LineMaxPos:", walls);
        row("NumLines:", String.valueOf(world.segments().size()));
        row("LinesAreSorted: false");
        BoundingBox points = new BoundingBox();
        world.points().forEach(points::add);
        bounds("MinPos:", "MaxPos:", points);
        row("NumPoints:", String.valueOf(world.points().size()));
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
        world.homes().forEach(this::home);
        for (Goal goal : world.goals()) {
            cairn(goal.type(), goal.position(), goal.headingRadians(), goal.name(), "");
        }
        for (Segment line : world.forbiddenLines()) {
            Position middle =
                    new Position((line.x1Meters() + line.x2Meters()) / 2, (line.y1Meters() + line.y2Meters()) / 2);
            cairn("ForbiddenLine", middle, 0, "", corners(line));
        }
        for (Area area : world.forbiddenAreas()) {
            cairn("ForbiddenArea", area.center(), area.rotationRadians(), "", corners(area));
        }
        for (Box box : world.boxes()) {
            Area area = box.area();
            cairn("Sim.BoxObstacle", area.center(), area.rotationRadians(), box.name(), corners(area));
        }
        for (Treadmill belt : world.treadmills()) {
            String speed = "v=" + millimeters(belt.speedMetersPerSecond());
            cairn("Sim.Treadmill", belt.area().center(), belt.directionRadians(), speed, corners(belt.area()));
        }
    }

    /** The format rotates a home's area by the home's heading; an area with another rotation is left out. */
    private void home(Home home) {
        String area = home.area()
                .filter(a -> a.rotationRadians() == home.headingRadians())
                .map(MapWriter::corners)
                .orElse("");
        cairn("RobotHome", home.position(), home.headingRadians(), home.name(), area);
    }

    private void cairn(String type, Position at, double radians, String name, String corners) {
        row(
                "Cairn:",
                type,
                millimeters(at.xMeters()),
                millimeters(at.yMeters()),
                degrees(radians),
                "\"\"",
                "ICON",
                quoted(name) + (corners.isEmpty() ? "" : " " + corners));
    }

    private static String corners(Area area) {
        return millimeters(area.minXMeters()) + " " + millimeters(area.minYMeters()) + " "
                + millimeters(area.maxXMeters()) + " " + millimeters(area.maxYMeters());
    }

    private static String corners(Segment line) {
        return millimeters(line.x1Meters()) + " " + millimeters(line.y1Meters()) + " " + millimeters(line.x2Meters())
                + " " + millimeters(line.y2Meters());
    }

    private static String quoted(String name) {
        StringBuilder quoted = new StringBuilder("\"");
        name.chars().forEach(c -> {
            boolean escaped = c == '"' || c == '\\';
            quoted.append(escaped ? "\\" : "").append(Character.isISOControl(c) ? ' ' : (char) c);
        });
        return quoted.append('"').toString();
    }

    // ---- walls and points ------------------------------------------------------------------------------------------

    private void lines() {
        row("LINES");
        world.segments().forEach(wall -> row(corners(wall)));
        row("DATA");
        world.points().forEach(point -> row(millimeters(point.xMeters()), millimeters(point.yMeters())));
    }

    /** The shortest decimal that is read as the same number of metres. */
    private static String millimeters(double meters) {
        return plain(BigDecimal.valueOf(meters).movePointRight(3));
    }

    /** Degrees rounded to 1e-6 if they are read as the same radians, else with all digits. */
    static String degrees(double radians) {
        double exact = Math.toDegrees(radians);
        BigDecimal round = BigDecimal.valueOf(Math.rint(exact * 1e6)).movePointLeft(6);
        if (Math.toRadians(round.doubleValue()) == radians) {
            return plain(round);
        }
        double degrees = exact;
        for (int i = 0; i < 4 && Math.toRadians(degrees) != radians; i++) {
            degrees = Math.toRadians(degrees) < radians ? Math.nextUp(degrees) : Math.nextDown(degrees);
        }
        return plain(BigDecimal.valueOf(degrees));
    }

    private static String plain(BigDecimal number) {
        return number.signum() == 0 ? "0" : number.stripTrailingZeros().toPlainString();
    }
}
