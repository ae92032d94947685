package simgsm.classroom.ui;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import simgsm.file.CsvLine;

/**
 * Content of a class's window.
 *
 * @param rows the results, the best first
 * @param seconds since the challenge began, until it is stopped; 0 before the first one
 * @param notice text of the latest refusal
 */
public record ClassView(List<Row> rows, Phase phase, long seconds, Optional<String> notice) {
    /** FREE: before the first challenge, results count from each student's first key. */
    public enum Phase {
        FREE,
        RUNNING,
        STOPPED
    }

    /**
     * A student's result.
     *
     * @param cells phone, name, robot, orders, keys, collisions, seconds, lesson, score
     * @param isBest true for the first result if it is at the goal
     * @param steps all steps of all lessons with their results, tries and hints
     */
    public record Row(List<String> cells, boolean isBest, String steps) {
        public String phone() {
            return cells.get(0);
        }

        /** The student's name, else the number of the phone. */
        String student() {
            return cells.get(1).isEmpty() ? phone() : cells.get(1);
        }

        /** The result as a line of a CSV file. */
        String line() {
            return CsvLine.of(Stream.concat(cells.stream(), Stream.of(steps)).toList());
        }
    }
}
