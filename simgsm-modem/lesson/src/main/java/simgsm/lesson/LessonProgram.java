package simgsm.lesson;

import java.util.List;

/**
 * A program that takes part in a lesson.
 *
 * @param name by which conditions and solutions refer to it
 * @param jar without its ending, such as {@code simgsm-phone}
 * @param options of its command line; names in braces are replaced
 * @param isLater whether it is started by the student and not with the lesson
 */
public record LessonProgram(String name, String jar, List<String> options, boolean isLater) {
    public LessonProgram {
        options = List.copyOf(options);
    }
}
