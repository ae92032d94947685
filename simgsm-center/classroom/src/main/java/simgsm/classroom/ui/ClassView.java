package simgsm.classroom.ui;

import java.util.List;
import java.util.Optional;
import simgsm.file.CsvLine;

/**
 * What the window of a class shows.
 *
 * @param rows the results, the best first
 * @param seconds since the challenge began, until it is stopped; 0 before the first one
 * @param notice of what has just been refused
 */
public record ClassView(List<Row> rows, Phase phase, long seconds, Optional<String> notice) {
    /** Whether results count: before the first challenge each student's from the first key on. */
    public enum Phase {
        FREE,
        RUNNING,
        STOPPED
    }

    /**
     * A student's result.
     *
     * @param cells phone, robot, orders, keys, collisions, seconds
     * @param isBest whether it is the first and at the goal
     * @param name that was typed in a browser; empty without one
     */
    public record Row(List<String> cells, boolean isBest, String name) {
        public String phone() {
            return cells.get(0);
        }

        /** The student's name, else the number of the phone. */
        String student() {
            return name.isEmpty() ? phone() : name;
        }

        /** As a line of a CSV file. */
        String line() {
            return CsvLine.of(cells);
        }
    }
}
