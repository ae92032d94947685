package simgsm.classroom.ui;

import java.util.List;
import java.util.Optional;
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
     * @param cells phone, robot, orders, keys, collisions, seconds
     * @param isBest true for the first result if it is at the goal
     * @param name typed in a browser; may be empty
     */
    public record Row(List<String> cells, boolean isBest, String name) {
        public String phone() {
            return cells.get(0);
        }

        /** The student's name, else the number of the phone. */
        String student() {
            return name.isEmpty() ? phone() : name;
        }

        /** The result as a line of a CSV file. */
        String line() {
            return CsvLine.of(cells);
        }
    }
}
