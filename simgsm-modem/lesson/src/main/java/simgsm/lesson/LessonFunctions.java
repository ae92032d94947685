package simgsm.lesson;

import java.util.List;
import java.util.Map;

/** The functions of {@code let}, implemented by a lesson's runner. */
public interface LessonFunctions {
    /** Number of arguments of each; {@code text} takes any number. */
    Map<String, Integer> ARGUMENTS = Map.of(
            "low",
            1,
            "high",
            1,
            "xor",
            1,
            "swapped",
            1,
            "submit",
            2,
            "half-heard",
            1,
            "most-twist",
            0,
            "shortest",
            0,
            "off",
            2,
            "side",
            1);

    String TEXT = "text";

    /** @throws IllegalArgumentException for an unknown function, or naming the expected arguments */
    String apply(String function, List<String> arguments);
}
