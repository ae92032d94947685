package simrobot.app.batch;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import simgsm.file.CsvLine;

/**
 * The results of one student's process.
 *
 * @param rows a line of {@link RunJudge#HEADER} for each seed
 */
record Grade(String name, List<String> rows) {
    private static final Pattern ROW =
            Pattern.compile("-?\\d+,(done|failed|collision|timeout),\\d+,\\d+,[0-9.]+,[0-9.]+,\\d+,.*");
    private static final int FIELDS = RunJudge.HEADER.split(",").length;
    private static final int STATE = 1;
    private static final int SECONDS = 4;
    private static final int METERS = 5;
    private static final String DONE = RunOutcome.State.DONE.word();

    static boolean isRow(String line) {
        return ROW.matcher(line).matches();
    }

    /** A row of a run that has told nothing. */
    static String failed(long seed, String text) {
        return seed + "," + CsvLine.of(List.of(RunOutcome.State.FAILED.word(), "1", "0", "0.000", "0.000", "0", text));
    }

    private Stream<String[]> fields(boolean isDone) {
        return rows.stream().map(row -> row.split(",", FIELDS)).filter(fields -> fields[STATE].equals(DONE) == isDone);
    }

    int done() {
        return (int) fields(true).count();
    }

    /** Mean time of the completed runs. */
    double meanSeconds() {
        return mean(SECONDS);
    }

    double meanMeters() {
        return mean(METERS);
    }

    private double mean(int field) {
        return fields(true)
                .mapToDouble(fields -> Double.parseDouble(fields[field]))
                .average()
                .orElse(0);
    }

    /** State and reason of the first run that is not done; empty if all are. */
    String text() {
        return fields(false)
                .findFirst()
                .map(fields -> fields[STATE] + ": " + unquoted(fields[FIELDS - 1]))
                .orElse("");
    }

    private static String unquoted(String field) {
        return field.startsWith("\"") ? field.substring(1, field.length() - 1).replace("\"\"", "\"") : field;
    }
}
