package simgsm.lesson;

import java.util.List;
import java.util.Optional;

/**
 * One condition of a step.
 *
 * @param patterns events required in this order
 * @param least count of the first event; only with a single pattern
 * @param most count; unlimited for a condition that must become true
 * @param different field; each of its values counts once; empty if all events count
 */
public record LessonCondition(List<EventPattern> patterns, int least, int most, Optional<String> different) {
    static final int NO_LIMIT = Integer.MAX_VALUE;

    /** These events in this order. */
    static LessonCondition inOrder(List<EventPattern> patterns) {
        return new LessonCondition(patterns, 1, NO_LIMIT, Optional.empty());
    }

    /** True if the condition only limits a number: it holds until too many events have occurred. */
    boolean isLimit() {
        return most != NO_LIMIT;
    }
}
