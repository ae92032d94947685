package simrobot.world;

import java.util.Optional;

/** A line {@code Cairn: Type x y heading "desc" ICON "name" [x1 y1 x2 y2]} of a map file. */
final class Cairn {
    private final String type;
    private final Position position;
    private final double headingRadians;
    private final String name;
    private final double[] corners;

    /** The source line; null for a written one. */
    private final LineTokens tokens;

    /** @param corners x1, y1, x2, y2, or nothing */
    Cairn(String type, Position position, double headingRadians, String name, double... corners) {
        this.type = type;
        this.position = position;
        this.headingRadians = headingRadians;
        this.name = name;
        this.corners = corners;
        tokens = null;
    }

    /** Creates a rectangle; the format turns it by the cairn's heading. */
    Cairn(String type, Area area, String name) {
        this(type, area.center(), area.rotationRadians(), name, area.ends());
    }

    /** @param tokens the line after the type */
    Cairn(String type, LineTokens tokens) throws WorldFormatException {
        this.type = type;
        this.tokens = tokens;
        position = new Position(tokens.meters("the cairn's x"), tokens.meters("the cairn's y"));
        headingRadians = tokens.radians("the cairn's heading");
        name = nameOf(tokens);
        corners = tokens.hasMore() ? cornersOf(tokens) : new double[0];
        tokens.end();
    }

    /** The name; old maps have no description, icon and name. */
    private static String nameOf(LineTokens tokens) throws WorldFormatException {
        if (!tokens.hasMore()) {
            return "";
        }
        tokens.word("a description");
        tokens.word("an icon");
        return tokens.word("a name in quotes");
    }

    private static double[] cornersOf(LineTokens tokens) throws WorldFormatException {
        return new double[] {
            tokens.meters("the area's x1"),
            tokens.meters("the area's y1"),
            tokens.meters("the area's x2"),
            tokens.meters("the area's y2")
        };
    }

    /** The type as spelled in the map. */
    String type() {
        return type;
    }

    Position position() {
        return position;
    }

    double headingRadians() {
        return headingRadians;
    }

    String name() {
        return name;
    }

    /** Rotated by the cairn's heading about the map's origin, as in ARIA. */
    Optional<Area> area() {
        return corners.length == 0 ? Optional.empty() : Optional.of(areaTurnedBy(headingRadians));
    }

    Area requiredArea() throws WorldFormatException {
        requireCorners();
        return areaTurnedBy(headingRadians);
    }

    /** The rectangle without rotation, because the heading is a belt's direction. */
    Area requiredUprightArea() throws WorldFormatException {
        requireCorners();
        return areaTurnedBy(0);
    }

    /** The line, which is not rotated. */
    Segment requiredLine() throws WorldFormatException {
        requireCorners();
        return new Segment(corners[0], corners[1], corners[2], corners[3]);
    }

    /**
     * A thousandth of the number in the cairn's name, {@code key=number}.
     *
     * @param most maximum absolute value
     */
    double thousandth(String key, String expected, int most) throws WorldFormatException {
        if (!name.startsWith(key + "=")) {
            throw tokens.fault('"' + name + '"', expected);
        }
        try {
            double number =
                    LineTokens.thousandth(name.substring(key.length() + 1).strip());
            if (Math.abs(number) <= most) {
                return number;
            }
        } catch (NumberFormatException notANumber) {
            // reported below
        }
        throw tokens.fault('"' + name + '"', expected + " of at most " + most * 1000);
    }

    private void requireCorners() throws WorldFormatException {
        if (corners.length == 0) {
            throw tokens.fault("no corners", "x1 y1 x2 y2 of the " + type);
        }
    }

    private Area areaTurnedBy(double radians) {
        return Area.between(corners[0], corners[1], corners[2], corners[3], radians);
    }

    /** The line of the file. */
    String line() {
        return String.join(
                " ",
                "Cairn:",
                type,
                MapWriter.millimeters(position.xMeters()),
                MapWriter.millimeters(position.yMeters()),
                MapWriter.degrees(headingRadians),
                "\"\"",
                "ICON",
                quoted(name) + (corners.length == 0 ? "" : " " + MapWriter.millimeters(corners)));
    }

    private static String quoted(String name) {
        StringBuilder quoted = new StringBuilder("\"");
        name.chars().forEach(c -> {
            boolean escaped = c == '"' || c == '\\';
            quoted.append(escaped ? "\\" : "").append(Character.isISOControl(c) ? ' ' : (char) c);
        });
        return quoted.append('"').toString();
    }
}
