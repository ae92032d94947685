package simgsm.lesson;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Reads {@code lesson.txt}: a line each for programs, variables, steps and their conditions. */
final class LessonReader {
    private static final int MAX_MINUTES = 240;

    private final String name;
    private int minutes;
    private final List<LessonProgram> programs = new ArrayList<>();
    private final List<String> closed = new ArrayList<>();
    private boolean captured;
    private final List<LessonAction> actions = new ArrayList<>();
    private final List<LessonStep> steps = new ArrayList<>();
    private final List<LessonVariable> variables = new ArrayList<>();
    private String step;
    private Optional<String> after = Optional.empty();
    private Optional<String> answer = Optional.empty();
    private final List<LessonCondition> conditions = new ArrayList<>();

    private LessonReader(String name) {
        this.name = name;
    }

    /** @throws LessonException naming lesson, line and what was expected */
    static Lesson read(String name, String text) throws LessonException {
        LessonReader reader = new LessonReader(name);
        int number = 0;
        for (String line : text.lines().toList()) {
            number++;
            if (!line.isBlank() && !line.startsWith("#")) {
                try {
                    reader.line(line.strip());
                } catch (LessonException e) {
                    throw new LessonException(name + "/lesson.txt, line " + number + ": " + e.getMessage());
                }
            }
        }
        reader.endStep();
        if (reader.steps.isEmpty() || reader.minutes == 0) {
            throw new LessonException(name + "/lesson.txt: expected minutes and at least one step");
        }
        return new Lesson(
                name,
                reader.minutes,
                reader.programs,
                reader.closed,
                reader.captured,
                reader.actions,
                reader.steps,
                reader.variables);
    }

    private void line(String line) throws LessonException {
        String[] parts = line.split("\\s+", 2);
        String rest = parts.length == 2 ? parts[1] : "";
        List<String> words = EventPattern.words(rest);
        switch (parts[0]) {
            case "minutes" -> minutes = number(rest, 1, MAX_MINUTES);
            case "program" -> program(words, false);
            case "later" -> program(words, true);
            case "closed" -> closed.addAll(words);
            case "capture" -> captured = true;
            case "draw" -> draw(words);
            case "let" -> let(words);
            case "keep" -> keep(words, rest);
            case "action" -> action(words);
            case "do" -> doing(rest);
            case "step" -> {
                endStep();
                step = one(words, "a name");
            }
            case "after" -> after = Optional.of(known(one(words, "a step's name")));
            case "answer" -> answer = Optional.of(one(words, "a name"));
            case "when" -> conditions.add(new LessonCondition(List.of(pattern(rest)), 1, LessonCondition.NO_LIMIT));
            case "then" -> then(rest);
            case "at-least" -> conditions.add(counted(rest, true));
            case "at-most" -> conditions.add(counted(rest, false));
            default -> throw new LessonException("unknown word " + parts[0]);
        }
    }

    private void program(List<String> words, boolean isLater) throws LessonException {
        if (words.size() < 2) {
            throw new LessonException("expected NAME PROGRAM [OPTION]...");
        }
        programs.add(new LessonProgram(words.get(0), words.get(1), words.subList(2, words.size()), isLater));
    }

    /** {@code draw A B from 1 2 3}, or {@code draw A from 20..60}: different values for the names. */
    private void draw(List<String> words) throws LessonException {
        int from = words.indexOf("from");
        if (from < 1 || from == words.size() - 1) {
            throw new LessonException("expected draw NAME... from VALUE... or LEAST..MOST");
        }
        List<String> values = new ArrayList<>();
        for (String word : words.subList(from + 1, words.size())) {
            values.addAll(range(word));
        }
        if (values.size() < from) {
            throw new LessonException("expected at least " + from + " values to draw from, found " + values.size());
        }
        variables.add(new LessonVariable(
                LessonVariable.Kind.DRAWN, List.copyOf(words.subList(0, from)), values, Optional.empty()));
    }

    private static List<String> range(String word) throws LessonException {
        int dots = word.indexOf("..");
        if (dots <= 0) {
            return List.of(word);
        }
        List<String> values = new ArrayList<>();
        int least = number(word.substring(0, dots), 0, 99_999);
        int most = number(word.substring(dots + 2), least, 99_999);
        for (int value = least; value <= most; value++) {
            values.add(Integer.toString(value));
        }
        return values;
    }

    private void let(List<String> words) throws LessonException {
        if (words.size() < 2) {
            throw new LessonException("expected let NAME FUNCTION [ARGUMENT]...");
        }
        variables.add(new LessonVariable(
                LessonVariable.Kind.COMPUTED,
                List.of(words.get(0)),
                List.copyOf(words.subList(1, words.size())),
                Optional.empty()));
    }

    /** {@code keep NAME FIELD SOURCE EVENT [TEST]...}: the field of the latest such event. */
    private void keep(List<String> words, String rest) throws LessonException {
        String[] parts = rest.split("\\s+", 3);
        if (words.size() < 4) {
            throw new LessonException("expected keep NAME FIELD SOURCE EVENT [TEST]...");
        }
        variables.add(new LessonVariable(
                LessonVariable.Kind.KEPT,
                List.of(words.get(0)),
                List.of(words.get(1)),
                Optional.of(EventPattern.parse(parts[2]))));
    }

    /** {@code action NAME [text|file]}. */
    private void action(List<String> words) throws LessonException {
        LessonAction.Input input = switch (words.size() == 2 ? words.get(1) : "") {
            case "text" -> LessonAction.Input.TEXT;
            case "file" -> LessonAction.Input.FILE;
            default -> LessonAction.Input.NONE;
        };
        if (words.isEmpty() || words.size() > 2 || words.size() == 2 && input == LessonAction.Input.NONE) {
            throw new LessonException("expected action NAME [text|file], found " + String.join(" ", words));
        }
        actions.add(new LessonAction(words.get(0), input, List.of()));
    }

    private void doing(String line) throws LessonException {
        if (actions.isEmpty()) {
            throw new LessonException("expected action NAME before do");
        }
        LessonAction last = actions.remove(actions.size() - 1);
        List<String> lines = new ArrayList<>(last.lines());
        lines.add(line);
        actions.add(new LessonAction(last.name(), last.input(), lines));
    }

    private EventPattern pattern(String text) throws LessonException {
        if (step == null) {
            throw new LessonException("expected step NAME before the first condition");
        }
        return EventPattern.parse(text);
    }

    private void then(String text) throws LessonException {
        EventPattern next = pattern(text);
        LessonCondition last = conditions.isEmpty() ? null : conditions.remove(conditions.size() - 1);
        if (last == null || last.least() != 1 || last.isLimit()) {
            throw new LessonException("expected when before then");
        }
        List<EventPattern> chain = new ArrayList<>(last.patterns());
        chain.add(next);
        conditions.add(new LessonCondition(List.copyOf(chain), 1, LessonCondition.NO_LIMIT));
    }

    private LessonCondition counted(String text, boolean isLeast) throws LessonException {
        String[] parts = text.split("\\s+", 2);
        if (parts.length < 2) {
            throw new LessonException("expected a number and SOURCE EVENT [TEST]...");
        }
        int count = number(parts[0], 0, 99_999);
        List<EventPattern> patterns = List.of(pattern(parts[1]));
        return isLeast
                ? new LessonCondition(patterns, count, LessonCondition.NO_LIMIT)
                : new LessonCondition(patterns, 0, count);
    }

    private void endStep() throws LessonException {
        if (step == null) {
            return;
        }
        if (conditions.isEmpty()) {
            throw new LessonException("step " + step + ": expected at least one condition");
        }
        steps.add(new LessonStep(step, after, answer, conditions));
        step = null;
        after = Optional.empty();
        answer = Optional.empty();
        conditions.clear();
    }

    private String known(String wanted) throws LessonException {
        if (steps.stream().noneMatch(each -> each.name().equals(wanted))) {
            throw new LessonException("expected a step above, found " + wanted);
        }
        return wanted;
    }

    private static String one(List<String> words, String what) throws LessonException {
        if (words.size() != 1) {
            throw new LessonException("expected " + what + ", found " + String.join(" ", words));
        }
        return words.get(0);
    }

    private static int number(String text, int least, int most) throws LessonException {
        if (text.matches("[0-9]{1,5}") && Integer.parseInt(text) >= least && Integer.parseInt(text) <= most) {
            return Integer.parseInt(text);
        }
        throw new LessonException("expected a number of " + least + " to " + most + ", found " + text);
    }

    /** For lists of words in one line of a text file. */
    static List<String> list(String text) {
        return Arrays.stream(text.strip().split("\\s+"))
                .filter(word -> !word.isEmpty())
                .toList();
    }
}
