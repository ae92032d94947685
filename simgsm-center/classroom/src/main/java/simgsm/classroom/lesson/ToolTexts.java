package simgsm.classroom.lesson;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import simgsm.console.Event;
import simgsm.console.TextBundle;

/** Results of a lesson's tools in words for the student. */
final class ToolTexts {
    private ToolTexts() {}

    /** A tool's event in words; may be empty. */
    static String of(Event event, TextBundle words) {
        Map<String, String> fields = event.fields();
        String output = fields.getOrDefault("output", "");
        if (!fields.getOrDefault("status", "0").equals("0")) {
            return event.name() + ": " + complaint(output);
        }
        return switch (event.name()) {
            case "decode" -> decoded(fields, words);
            case "drive" ->
                words.of(
                        "lesson.told.drive",
                        fields.get("name"),
                        fields.get("travelled"),
                        fields.get("collisions"),
                        fields.get("near"),
                        fields.get("far"));
            case "hear" -> words.of("lesson.told.heard", fields.get("count"), heard(output));
            case "pdu" -> output;
            case "java" -> output;
            default -> "";
        };
    }

    /** As {@code one 0.57, - 0.95}. */
    private static String heard(String output) {
        return output.lines()
                .map(line -> line.substring(line.indexOf('\t') + 1).replace('\t', ' '))
                .collect(Collectors.joining(", "));
    }

    private static String decoded(Map<String, String> fields, TextBundle words) {
        String path = fields.getOrDefault(LessonTools.OPTIONS, "").replace('\\', '/');
        String file = path.substring(path.lastIndexOf('/') + 1);
        return fields.get("count").equals("0")
                ? words.of("lesson.told.none", file)
                : words.of("lesson.told.keys", file, fields.get("count"), fields.get("keys"));
    }

    /** A program's error lines without its name; all lines if none has the name. */
    private static String complaint(String output) {
        List<String> own = output.lines()
                .filter(line -> line.matches("(simgsm-[a-z]+|simrobot): .*"))
                .map(line -> line.substring(line.indexOf(' ') + 1)
                        .replaceFirst("; see --help$", "")
                        .replaceFirst("^--[a-z-]+:? ", ""))
                .toList();
        return own.isEmpty() ? output : String.join("\n", own);
    }
}
