package simgsm.lesson;

import java.util.List;
import java.util.Map;

/** The functions that {@code let} may use; a lesson's runner knows them. */
public interface LessonFunctions {
    /** How many arguments each takes; {@code text} takes any number. */
    Map<String, Integer> ARGUMENTS = Map.of(
            "low", 1, "high", 1, "xor", 1, "swapped", 1, "submit", 2, "half-heard", 1, "most-twist", 0, "shortest", 0);

    String TEXT = "text";

    /** @throws IllegalArgumentException for an unknown function, or saying what its arguments should be */
    String apply(String function, List<String> arguments);
}
