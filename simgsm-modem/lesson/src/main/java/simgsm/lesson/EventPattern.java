package simgsm.lesson;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import simgsm.console.CommandException;
import simgsm.console.ConsoleCommand;
import simgsm.console.Event;

/**
 * The events accepted by a condition.
 *
 * @param source program that prints them, or {@code student}, {@code trace}, {@code tool}
 */
public record EventPattern(String source, String event, List<FieldTest> tests) {
    /** Reads {@code SOURCE EVENT [TEST]...}. */
    public static EventPattern parse(String text) throws LessonException {
        List<String> words = words(text);
        if (words.size() < 2) {
            throw new LessonException("expected SOURCE EVENT [FIELD=VALUE]..., found " + text);
        }
        List<FieldTest> tests = new ArrayList<>();
        for (String word : words.subList(2, words.size())) {
            tests.add(FieldTest.parse(word));
        }
        return new EventPattern(words.get(0), words.get(1), List.copyOf(tests));
    }

    /** The words of a line; quoted ones may contain blanks. */
    static List<String> words(String text) throws LessonException {
        try {
            return new ConsoleCommand("", text).words();
        } catch (CommandException e) {
            throw new LessonException(e.getMessage());
        }
    }

    public boolean matches(String from, Event found, UnaryOperator<String> variables) {
        return source.equals(from)
                && event.equals(found.name())
                && tests.stream().allMatch(test -> test.isPassedBy(found.fields(), variables));
    }
}
