package simgsm.lesson;

import java.util.List;

/**
 * What a button of a lesson does.
 *
 * @param input what the student gives with it
 * @param lines of a solution; {@code {input}} is that input
 */
public record LessonAction(String name, Input input, List<String> lines) {
    /** Nothing, a line of text, or a file's path. */
    public enum Input {
        NONE,
        TEXT,
        FILE
    }

    public LessonAction {
        lines = List.copyOf(lines);
    }
}
