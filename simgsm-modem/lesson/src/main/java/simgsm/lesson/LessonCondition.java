package simgsm.lesson;

import java.util.List;
import java.util.Optional;

/**
 * One condition of a step.
 *
 * @param patterns events that have to come in this order
 * @param least how often the first must come; only with a single pattern
 * @param most how often it may come at most; without a limit for a condition that must come true
 * @param different the field whose different values count, each once; empty where all events count
 */
public record LessonCondition(List<EventPattern> patterns, int least, int most, Optional<String> different) {
    static final int NO_LIMIT = Integer.MAX_VALUE;

    /** These events in this order. */
    static LessonCondition inOrder(List<EventPattern> patterns) {
        return new LessonCondition(patterns, 1, NO_LIMIT, Optional.empty());
    }

    /** Whether it only limits a number, so that it is true until too many events have come. */
    boolean isLimit() {
        return most != NO_LIMIT;
    }
}
