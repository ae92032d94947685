package simgsm.lesson;

import java.util.List;
import java.util.Optional;

/**
 * A name in braces and the source of its value.
 *
 * @param words for a drawn value the values to choose from; for a computed one the function and its arguments
 * @param pattern for a value taken from an event; its field is the only word
 */
public record LessonVariable(Kind kind, List<String> names, List<String> words, Optional<EventPattern> pattern) {
    /** Drawn values are part of the task; the others of the solution. */
    public enum Kind {
        DRAWN,
        COMPUTED,
        KEPT
    }
}
