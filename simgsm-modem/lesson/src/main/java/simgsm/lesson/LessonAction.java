package simgsm.lesson;

import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;

/**
 * The action of a lesson's button.
 *
 * @param stepsAbove number of steps above the button in the lesson's text and window
 * @param input by the student
 * @param lines of a solution; {@code {input}} is that input
 */
public record LessonAction(String name, int stepsAbove, Input input, List<String> lines) {
    /** The student's input. */
    public sealed interface Input permits Nothing, Text, Range, File {}

    /** A button alone. */
    public record Nothing() implements Input {}

    /** A line of text. */
    public record Text() implements Input {}

    /** A number between two limits, both included. */
    public record Range(int least, int most, boolean isWhole) implements Input {
        /**
         * The number in digits with a dot, if the text begins with one in range; a comma may stand for the dot. Equal numbers
         * have equal digits: {@code 8} and {@code 08.0} are one.
         */
        public Optional<String> number(String text) {
            String word = text.strip().split("\\s+", 2)[0].replace(',', '.').replace('\u2212', '-');
            if (!word.matches(isWhole ? "-?[0-9]{1,9}" : "-?[0-9]{1,9}([.][0-9]{1,9})?")) {
                return Optional.empty();
            }
            BigDecimal number = new BigDecimal(word).stripTrailingZeros();
            boolean isInRange = number.doubleValue() >= least && number.doubleValue() <= most;
            return isInRange ? Optional.of(number.toPlainString()) : Optional.empty();
        }
    }

    /** @param ending of the file name, such as {@code wav}; empty for any */
    public record File(String ending) implements Input {}

    public LessonAction {
        lines = List.copyOf(lines);
    }
}
