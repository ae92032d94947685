package simgsm.lesson;

import java.util.List;

/** The functions that {@code let} may use; a lesson's runner knows them. */
public interface LessonFunctions {
    /** @throws IllegalArgumentException for an unknown function, or saying what its arguments should be */
    String apply(String function, List<String> arguments);
}
