package simgsm.lesson;

import java.util.List;

/**
 * One condition of a step.
 *
 * @param patterns events that have to come in this order
 * @param least how often the first must come; only with a single pattern
 * @param most how often it may come at most; without a limit for a condition that must come true
 */
public record LessonCondition(List<EventPattern> patterns, int least, int most) {
    static final int NO_LIMIT = Integer.MAX_VALUE;

    /** Whether it only limits a number, so that it is true until too many events have come. */
    boolean isLimit() {
        return most != NO_LIMIT;
    }
}
