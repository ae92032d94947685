package simrobot.http;

import static simgsm.draw.SvgCanvas.escaped;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import simgsm.console.TextBundle;
import simgsm.draw.Appearance;
import simgsm.web.PageBody;
import simgsm.web.UrlPaths;
import simrobot.drawing.NumberTexts;
import simrobot.drawing.PlaceNames;
import simrobot.drawing.Viewport;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;
import simrobot.world.World;

/**
 * The page: the map, the cameras and a table of the robots. It loads nothing from other servers. A script refreshes it in
 * place; without scripts a browser reloads it every 3 s.
 */
final class Page {
    /** The Content-Security-Policy: forbids loading from other servers, whatever a robot's name contains. */
    static final String POLICY =
            "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src 'self';"
                    + " connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

    /** Limited because each camera causes a request every 150 ms. */
    private static final int MOST_CAMERAS = 12;

    private static final int MOST_ROWS = 200;

    private final TextBundle texts;
    private final PlaceNames names;
    /** The template before the map. */
    private final String before;

    private final String after;
    /** The world of the cached floor. */
    private World known;

    private PageBody.Part floor;

    Page(Locale language) {
        Locale locale = TextBundle.bundleLocale(language);
        names = PlaceNames.in(locale);
        texts = new TextBundle(ResourceBundle.getBundle("simrobot.http.messages", locale), Locale.ROOT);
        try (InputStream in = Page.class.getResourceAsStream("page.html")) {
            String[] parts = new String(in.readAllBytes(), StandardCharsets.UTF_8).split("\\{\\{map\\}\\}", 2);
            before = parts[0];
            after = parts[1];
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns the page for a scene. */
    PageBody of(SimulationSnapshot scene, WebSource source) {
        String title = texts.of("page.map", scene.world().name());
        return new PageBody(
                filled(before, scene, source) + WorldMap.opening(WorldMap.whole(scene.world()), title),
                floor(scene.world()),
                WorldMap.robots(scene, WorldMap.whole(scene.world()), names) + filled(after, scene, source));
    }

    /** Returns the map of a view as SVG. */
    String map(SimulationSnapshot scene, Viewport view) {
        return WorldMap.file(scene, view, texts.of("page.map", scene.world().name()), names);
    }

    private synchronized PageBody.Part floor(World world) {
        if (known != world) {
            floor = new PageBody.Part(WorldMap.floor(world, WorldMap.whole(world), names));
            known = world;
        }
        return floor;
    }

    private String filled(String template, SimulationSnapshot scene, WebSource source) {
        String world = scene.world().name();
        String rows = scene.robots().stream()
                .limit(MOST_ROWS)
                .map(robot -> row(robot, source))
                .collect(Collectors.joining());
        List<RobotSnapshot> seeing =
                scene.robots().stream().filter(RobotSnapshot::simulated).toList();
        String cameras = seeing.stream().limit(MOST_CAMERAS).map(this::camera).collect(Collectors.joining());
        int more = seeing.size() - MOST_CAMERAS;
        return template.replace("{{language}}", texts.of("page.language"))
                .replace("{{light}}", WorldMap.variables(Appearance.LIGHT))
                .replace("{{dark}}", WorldMap.variables(Appearance.DARK))
                .replace("{{h.robots}}", word("page.robots"))
                .replace("{{h.cameras}}", word("page.cameras"))
                .replace("{{pause}}", word("page.pause"))
                .replace("{{resume}}", word("page.resume"))
                .replace("{{lost}}", word("page.lost"))
                .replace("{{data}}", word("page.data"))
                .replace("{{th}}", heads())
                .replace("{{more}}", more > 0 ? "<p>" + escaped(texts.of("page.more", more)) + "</p>" : "")
                .replace("{{cameras}}", cameras)
                .replace("{{rows}}", rows)
                // last, because a world's name may contain any of the placeholders above
                .replace("{{world}}", escaped(world));
    }

    private String word(String key) {
        return escaped(texts.of(key));
    }

    private String heads() {
        return Stream.of("name", "number", "status", "place", "heading", "speed", "battery")
                .map(column -> "<th scope=\"col\">" + word("robot." + column) + "</th>")
                .collect(Collectors.joining());
    }

    private static String row(RobotSnapshot robot, WebSource source) {
        String place = NumberTexts.meters(robot.xMeters()) + " " + NumberTexts.meters(robot.yMeters());
        String name = escaped(robot.name());
        return "<tr data-robot=\"" + name + "\"><th scope=\"row\"><a href=\"" + path(robot) + "\">" + name + "</a></th>"
                + cell("number", source.number(robot.name()))
                + cell("status", robot.status().text())
                + cell("place", place)
                + cell("heading", NumberTexts.degrees(robot.headingRadians()))
                + cell("speed", NumberTexts.fixed(robot.speedMetersPerSecond(), 2))
                + cell("battery", NumberTexts.fixed(robot.condition().batteryVolts(), 1)) + "</tr>\n";
    }

    private static String path(RobotSnapshot robot) {
        return "/robots/" + escaped(UrlPaths.encoded(robot.name()));
    }

    private static String cell(String column, String value) {
        return "<td class=\"" + column + "\">" + escaped(value) + "</td>";
    }

    private String camera(RobotSnapshot robot) {
        String path = path(robot);
        String name = escaped(robot.name());
        return "<figure><img class=\"camera\" src=\"" + path + "/camera.jpg\" width=\"320\" height=\"240\" alt=\""
                + escaped(texts.of("page.camera", robot.name())) + "\"><figcaption>" + name + " \u00b7 <a href=\""
                + path + "/camera.jpg\">" + word("page.picture") + "</a> \u00b7 <a href=\"" + path + "/camera.mjpg\">"
                + word("page.stream") + "</a></figcaption></figure>\n";
    }
}
