package simrobot.app.batch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.ResourceBundle;
import java.util.stream.Collectors;
import simgsm.console.TextBundle;
import simgsm.draw.SvgCanvas;
import simgsm.file.CsvLine;
import simgsm.file.FileErrors;

/** The results of a folder's processes: {@code grades.html}, the best first, and {@code grades.csv} with a line for each run. */
final class GradePage {
    private static final String STYLE = "body{font-family:sans-serif;margin:2em}table{border-collapse:collapse}"
            + "th,td{border:1px solid #999;padding:.3em .6em;text-align:left}";

    private final TextBundle texts;

    private GradePage(Locale language) {
        Locale locale = TextBundle.bundleLocale(language);
        texts = new TextBundle(ResourceBundle.getBundle("simrobot.app.grades", locale), Locale.ROOT);
    }

    /** @param facts of all runs: world, goal, first seed, last seed */
    static void write(Path folder, List<Grade> grades, Locale language, List<String> facts) throws IOException {
        List<Grade> ranked = grades.stream()
                .sorted(Comparator.comparingInt((Grade grade) -> -grade.done())
                        .thenComparingDouble(Grade::meanSeconds)
                        .thenComparing(Grade::name))
                .toList();
        write(folder.resolve("grades.html"), new GradePage(language).html(ranked, facts));
        String rows = ranked.stream()
                .flatMap(grade ->
                        grade.rows().stream().map(row -> CsvLine.of(List.of(grade.name())) + "," + row + "\n"))
                .collect(Collectors.joining());
        write(folder.resolve("grades.csv"), "name," + RunJudge.HEADER + "\n" + rows);
    }

    private static void write(Path file, String text) throws IOException {
        FileErrors.naming(file, () -> Files.writeString(file, text));
    }

    private String html(List<Grade> grades, List<String> facts) {
        StringBuilder html = new StringBuilder("<!DOCTYPE html>\n<html lang=\"" + texts.of("language") + "\"><head>"
                + "<meta charset=\"utf-8\"><title>" + texts.of("title") + "</title><style>" + STYLE
                + "</style></head><body>\n<h1>" + texts.of("title") + "</h1>\n<p>"
                + SvgCanvas.escaped(texts.of("facts", facts.toArray())) + "</p>\n<table>\n");
        row(
                html,
                "th",
                List.of("name", "done", "seconds", "meters", "text").stream()
                        .map(texts::of)
                        .toList());
        for (Grade grade : grades) {
            boolean isDone = grade.done() > 0;
            row(
                    html,
                    "td",
                    List.of(
                            grade.name(),
                            grade.done() + " / " + grade.rows().size(),
                            isDone ? RunOutcome.threeDecimals(grade.meanSeconds()) : "",
                            isDone ? RunOutcome.threeDecimals(grade.meanMeters()) : "",
                            grade.text()));
        }
        return html.append("</table>\n</body></html>\n").toString();
    }

    private static void row(StringBuilder html, String cell, List<String> fields) {
        html.append("<tr>");
        fields.forEach(field -> html.append('<' + cell + '>' + SvgCanvas.escaped(field) + "</" + cell + '>'));
        html.append("</tr>\n");
    }
}
