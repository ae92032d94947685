package simrobot.http;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simrobot.robot.Pioneer2Dx;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.Area;
import simrobot.world.Position;
import simrobot.world.Segment;
import simrobot.world.World;

/** The world from above as SVG, in metres, y upward; its colours are the page's. */
final class WorldMap {
    private static final double MARGIN_METERS = 0.4;
    private static final double HOME_METERS = 0.25;

    /** Points that fall into the same square of this size are drawn as one. */
    private static final double POINT_RASTER_METERS = 0.05;

    private static final double LABEL_PIXELS = 17;
    private static final double USUAL_PIXELS = 1000;

    private final double pixelMeters;

    private WorldMap(Area ground) {
        pixelMeters = Math.max(ground.maxXMeters() - ground.minXMeters(), ground.maxYMeters() - ground.minYMeters())
                / USUAL_PIXELS;
    }

    static String svg(SimulationSnapshot scene, String title) {
        Area ground = scene.world().ground();
        return new WorldMap(ground).draw(scene, ground, title);
    }

    private String draw(SimulationSnapshot scene, Area ground, String title) {
        World world = scene.world();
        String box = Stream.of(
                        ground.minXMeters() - MARGIN_METERS,
                        -ground.maxYMeters() - MARGIN_METERS,
                        ground.maxXMeters() - ground.minXMeters() + 2 * MARGIN_METERS,
                        ground.maxYMeters() - ground.minYMeters() + 2 * MARGIN_METERS)
                .map(number -> Html.number(number, 2))
                .collect(Collectors.joining(" "));
        StringBuilder svg = new StringBuilder("<svg id=\"map\" role=\"img\" viewBox=\"" + box + "\" aria-label=\""
                + Html.text(title) + "\">\n<g transform=\"scale(1,-1)\">\n");
        world.treadmills().forEach(belt -> svg.append(area(belt.area(), "belt")));
        world.forbiddenAreas().forEach(area -> svg.append(area(area, "forbidden")));
        world.boxes().forEach(each -> svg.append(area(each.area(), "box")));
        world.homes().forEach(home -> svg.append(ring(home.position(), "home")));
        world.goals().forEach(goal -> svg.append(ring(goal.position(), "goal")));
        svg.append(path("wall", lines(world.segments()), 2.2));
        svg.append(path("point", dots(world.points()), 2));
        svg.append("<g id=\"robots\">\n");
        scene.robots().forEach(robot -> svg.append(robot(robot)));
        return svg.append("</g>\n</g>\n</svg>\n").toString();
    }

    /** So many pixels wide, at the usual size of the map. */
    private String stroke(double pixels) {
        return " stroke-width=\"" + Html.number(pixels * pixelMeters, 4) + "\"";
    }

    private String dashes(double pixels) {
        return " stroke-dasharray=\"" + Html.number(pixels * pixelMeters, 4) + "\"";
    }

    private String path(String kind, String steps, double pixels) {
        return steps.isEmpty() ? "" : "<path class=\"" + kind + "\"" + stroke(pixels) + " d=\"" + steps + "\"/>\n";
    }

    private static String lines(List<Segment> segments) {
        return segments.stream()
                .map(line ->
                        "M" + pair(line.x1Meters(), line.y1Meters()) + "L" + pair(line.x2Meters(), line.y2Meters()))
                .collect(Collectors.joining());
    }

    private static String dots(List<Position> points) {
        Set<String> drawn = new HashSet<>();
        return points.stream()
                .map(point -> pair(raster(point.xMeters()), raster(point.yMeters())))
                .filter(drawn::add)
                .map(place -> "M" + place + "h.01")
                .collect(Collectors.joining());
    }

    private static double raster(double meters) {
        return Math.rint(meters / POINT_RASTER_METERS) * POINT_RASTER_METERS;
    }

    private static String pair(double x, double y) {
        return Html.number(x, 3) + " " + Html.number(y, 3);
    }

    /** Lines that bind nobody's wheels are broken. */
    private String dashesOf(String kind) {
        return kind.equals("box") || kind.equals("goal") ? "" : dashes(4);
    }

    private String area(Area area, String kind) {
        String corners = area.corners().stream()
                .map(corner -> pair(corner.xMeters(), corner.yMeters()))
                .collect(Collectors.joining(" "));
        return "<polygon class=\"" + kind + "\"" + stroke(1.2) + dashesOf(kind) + " points=\"" + corners + "\"/>\n";
    }

    private String ring(Position place, String kind) {
        return "<circle class=\"" + kind + "\"" + stroke(1.5) + dashesOf(kind) + " cx=\""
                + Html.number(place.xMeters(), 3) + "\" cy=\"" + Html.number(place.yMeters(), 3) + "\" r=\""
                + HOME_METERS + "\"/>\n";
    }

    /** The body, an arrowhead, and its name upright. */
    private String robot(RobotSnapshot robot) {
        StringBuilder body = new StringBuilder();
        for (double[] corner : Pioneer2Dx.octagon()) {
            body.append(pair(corner[0], corner[1])).append(' ');
        }
        return "<g class=\"robot\" transform=\"translate(" + Html.number(robot.xMeters(), 3) + ","
                + Html.number(robot.yMeters(), 3) + ")\"><g transform=\"rotate("
                + Html.number(StatusJson.degrees(robot.headingRadians()), 1) + ")\"><polygon class=\"body\"" + stroke(1)
                + " points=\""
                + body.toString().strip() + "\"/><path class=\"nose\" d=\"M.14 0L-.02 .09L-.02-.09Z\"/></g>"
                + "<text transform=\"scale(1,-1)\" x=\".3\" y=\"-.22\"" + stroke(3) + " font-size=\""
                + Html.number(LABEL_PIXELS * pixelMeters, 3) + "\">" + Html.text(robot.name()) + "</text></g>\n";
    }
}
