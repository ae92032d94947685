package simgsm.lesson;

import java.util.List;

/**
 * A program that takes part in a lesson.
 *
 * @param name in conditions and solutions
 * @param jar without its ending, such as {@code simgsm-phone}
 * @param options of its command line; names in braces are replaced
 * @param isLater true if the student starts it, not the lesson
 */
public record LessonProgram(String name, String jar, List<String> options, boolean isLater) {
    public LessonProgram {
        options = List.copyOf(options);
    }
}
