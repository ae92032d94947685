package simrobot.world;

import java.util.Optional;

/** The rest of a {@code Cairn: Type x y theta "desc" ICON "name" [x1 y1 x2 y2]}. */
final class Cairn {
    private final LineTokens tokens;
    private final Position position;
    private final double headingRadians;
    private final String name;
    private final double[] corners;

    Cairn(LineTokens tokens) throws WorldFormatException {
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

    Area requiredArea(String type) throws WorldFormatException {
        requireCorners(type);
        return areaTurnedBy(headingRadians);
    }

    /** Not rotated, for the heading is a belt's direction. */
    Area requiredUprightArea(String type) throws WorldFormatException {
        requireCorners(type);
        return areaTurnedBy(0);
    }

    /** A line is not rotated. */
    Segment requiredLine() throws WorldFormatException {
        requireCorners("ForbiddenLine");
        return new Segment(corners[0], corners[1], corners[2], corners[3]);
    }

    /** The name of a belt is its speed: {@code v=-300}, in mm/s. */
    double beltSpeedMetersPerSecond() throws WorldFormatException {
        String expected = "a belt speed \"v=...\" in mm/s";
        if (!name.startsWith("v=")) {
            throw tokens.fault('"' + name + '"', expected);
        }
        try {
            double metersPerSecond = LineTokens.thousandth(name.substring(2).strip());
            if (Math.abs(metersPerSecond) <= 10) {
                return metersPerSecond;
            }
        } catch (NumberFormatException notANumber) {
            // reported below
        }
        throw tokens.fault('"' + name + '"', expected + " of at most 10000");
    }

    private void requireCorners(String type) throws WorldFormatException {
        if (corners.length == 0) {
            throw tokens.fault("no corners", "x1 y1 x2 y2 of the " + type);
        }
    }

    private Area areaTurnedBy(double radians) {
        return Area.between(corners[0], corners[1], corners[2], corners[3], radians);
    }
}
