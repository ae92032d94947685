package simrobot.http;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import simgsm.console.TextBundle;
import simrobot.simulation.RobotSnapshot;
import simrobot.simulation.SimulationSnapshot;

/**
 * The one page: the map, a table of the robots, and their cameras. It fetches nothing from elsewhere. A script refreshes
 * it in place; a browser without scripts loads it again every few seconds.
 */
final class Page {
    /** Nothing from elsewhere, whatever stands in a name. */
    static final String POLICY =
            "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src 'self';"
                    + " connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

    /** So many pictures a browser fetches at ease. */
    private static final int MOST_CAMERAS = 12;

    private static final int MOST_ROWS = 200;

    private final TextBundle texts;
    private final String template;

    Page(Locale language) {
        texts = WebTexts.in(language);
        template = Template.read("page.html");
    }

    String of(SimulationSnapshot scene, WebSource source) {
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
                .replace("{{h.robots}}", word("page.robots"))
                .replace("{{h.cameras}}", word("page.cameras"))
                .replace("{{pause}}", word("page.pause"))
                .replace("{{resume}}", word("page.resume"))
                .replace("{{lost}}", word("page.lost"))
                .replace("{{data}}", word("page.data"))
                .replace("{{th}}", heads())
                .replace("{{more}}", more > 0 ? "<p>" + Html.text(texts.of("page.more", more)) + "</p>" : "")
                .replace("{{cameras}}", cameras)
                .replace("{{rows}}", rows)
                .replace("{{map}}", WorldMap.svg(scene, texts.of("page.map", world)))
                // last, for it is the world's own
                .replace("{{world}}", Html.text(world));
    }

    private String word(String key) {
        return Html.text(texts.of(key));
    }

    private String heads() {
        return java.util.stream.Stream.of("name", "number", "status", "place", "heading", "speed", "battery")
                .map(column -> "<th scope=\"col\">" + word("robot." + column) + "</th>")
                .collect(Collectors.joining());
    }

    private static String row(RobotSnapshot robot, WebSource source) {
        String place = Html.number(robot.xMeters(), 3) + " " + Html.number(robot.yMeters(), 3);
        return "<tr data-robot=\"" + Html.text(robot.name()) + "\"><th scope=\"row\"><a href=\"/robots/"
                + Html.text(UrlPaths.encoded(robot.name())) + "\">" + Html.text(robot.name()) + "</a></th>"
                + cell("number", source.number(robot.name()))
                + cell("status", robot.status().text())
                + cell("place", place)
                + cell("heading", Html.number(StatusJson.degrees(robot.headingRadians()), 1))
                + cell("speed", Html.number(robot.speedMetersPerSecond(), 2))
                + cell("battery", Html.number(robot.condition().batteryVolts(), 1)) + "</tr>\n";
    }

    private static String cell(String column, String value) {
        return "<td class=\"" + column + "\">" + Html.text(value) + "</td>";
    }

    private String camera(RobotSnapshot robot) {
        String path = "/robots/" + Html.text(UrlPaths.encoded(robot.name()));
        return "<figure><img class=\"camera\" src=\"" + path + "/camera.jpg\" width=\"320\" height=\"240\" alt=\""
                + Html.text(texts.of("page.camera", robot.name())) + "\"><figcaption>" + Html.text(robot.name())
                + " \u00b7 <a href=\"" + path + "/camera.jpg\">" + word("page.picture") + "</a> \u00b7 <a href=\""
                + path
                + "/camera.mjpg\">" + word("page.stream") + "</a></figcaption></figure>\n";
    }
}
