package simgsm.lesson;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads {@code lesson.txt}: a line each for programs, variables, steps and their conditions. */
final class LessonReader {
    private static final int MAX_MINUTES = 240;

    /** Words with another meaning than a program's name. */
    private static final Set<String> TAKEN =
            Set.of(("predict answer hint start stop tool java drive capture give use at submit act " + "different")
                    .split(" "));

    private static final String ACTION = "action NAME [text|number LEAST..MOST|integer LEAST..MOST|file [ENDING]]";
    private static final Pattern RANGE = Pattern.compile("(number|integer) (-?[0-9]{1,6})[.][.](-?[0-9]{1,6})");
    private static final Set<String> SOURCES = Set.of("centre", "trace", "tool", LessonRun.STUDENT);
    private static final List<String> PROGRAMS = List.of("simgsm-phone", "simrobot", "simgsm-cells");
    private static final List<String> CENTRE_OPTIONS =
            List.of("--call-waiting", "--handover", "--rtp", "--t303", "--tones");
    private static final List<String> WORDS =
            List.of(("minutes centre program later closed capture draw let keep action do step after "
                            + "again answer when then at-least at-most")
                    .split(" "));

    private final Map<Integer, String> lines = new LinkedHashMap<>();
    private final Map<Integer, EventPattern> patterns = new LinkedHashMap<>();
    private int number;
    private int minutes;
    private final Map<String, String> center = new LinkedHashMap<>();
    private final List<LessonProgram> programs = new ArrayList<>();
    private final List<String> closed = new ArrayList<>();
    private boolean captured;
    private final List<LessonAction> actions = new ArrayList<>();
    private final List<LessonStep> steps = new ArrayList<>();
    private final List<LessonVariable> variables = new ArrayList<>();
    private String step;
    private Optional<String> after = Optional.empty();
    private final List<EventPattern> again = new ArrayList<>();
    private Optional<String> answer = Optional.empty();
    private final List<LessonCondition> conditions = new ArrayList<>();

    private LessonReader() {}

    /**
     * Reads a lesson.
     *
     * @param file for error texts
     * @throws LessonException naming file, line and expected form
     */
    static Lesson read(String name, String file, String text) throws LessonException {
        LessonReader reader = new LessonReader();
        try {
            for (String line : text.lines().toList()) {
                reader.number++;
                if (!line.isBlank() && !line.startsWith("#")) {
                    reader.lines.put(reader.number, line);
                    reader.line(line.strip());
                }
            }
            reader.endStep();
            reader.requireKnownNames();
            reader.requireKnownSources();
        } catch (LessonException e) {
            throw new LessonException(file + ", line " + reader.number + ": " + e.getMessage());
        }
        if (reader.steps.isEmpty() || reader.minutes == 0) {
            throw new LessonException(file + ": expected minutes and at least one step");
        }
        return new Lesson(
                name,
                reader.minutes,
                reader.center,
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
            case "centre" -> center(words);
            case "program" -> program(words, false);
            case "later" -> program(words, true);
            case "closed" -> closed(words);
            case "capture" -> captured = true;
            case "draw" -> draw(words);
            case "let" -> let(words);
            case "keep" -> keep(words, rest);
            case "action" -> {
                endStep();
                action(words);
            }
            case "do" -> doing(rest);
            case "step" -> {
                endStep();
                step = one(words, "a name");
                require(steps.stream().noneMatch(each -> each.name().equals(step)), "a step's name once", step);
            }
            case "after" -> after = Optional.of(known(inStep(one(words, "a step's name"))));
            case "again" -> again.add(pattern(rest));
            case "answer" -> answer = Optional.of(inStep(one(words, "a name")));
            case "when" -> conditions.add(LessonCondition.inOrder(List.of(pattern(rest))));
            case "then" -> then(rest);
            case "at-least" -> conditions.add(counted(rest, true));
            case "at-most" -> conditions.add(counted(rest, false));
            default -> throw new LessonException("expected one of " + String.join(", ", WORDS) + "; found " + parts[0]);
        }
    }

    private void closed(List<String> words) throws LessonException {
        for (String word : words) {
            require(word.matches("[0-9]{1,15}"), "numbers of 1 to 15 digits", word);
            closed.add(word);
        }
    }

    private void center(List<String> words) throws LessonException {
        require(words.size() == 2, "OPTION VALUE", String.join(" ", words));
        require(CENTRE_OPTIONS.contains(words.get(0)), "one of " + String.join(", ", CENTRE_OPTIONS), words.get(0));
        center.put(words.get(0).substring(2), words.get(1));
    }

    private void program(List<String> words, boolean isLater) throws LessonException {
        if (words.size() < 2) {
            throw new LessonException("expected NAME PROGRAM [OPTION]...");
        }
        String program = words.get(0);
        require(!TAKEN.contains(program) && !SOURCES.contains(program), "another name for a program", program);
        require(programs.stream().noneMatch(each -> each.name().equals(program)), "a program's name once", program);
        require(PROGRAMS.contains(words.get(1)), "one of " + String.join(", ", PROGRAMS), words.get(1));
        programs.add(new LessonProgram(words.get(0), words.get(1), words.subList(2, words.size()), isLater));
    }

    /** {@code draw A B from 1 2 3}, or {@code draw A from 20..60}: draws different values for the names. */
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
        String function = words.get(1);
        if (!function.equals(LessonFunctions.TEXT)) {
            Integer arguments = LessonFunctions.ARGUMENTS.get(function);
            require(
                    arguments != null,
                    "a function of " + String.join(", ", new TreeSet<>(LessonFunctions.ARGUMENTS.keySet())) + ", "
                            + LessonFunctions.TEXT,
                    function);
            require(
                    words.size() - 2 == arguments,
                    function + " with " + arguments + " arguments",
                    Integer.toString(words.size() - 2));
        }
        variables.add(new LessonVariable(
                LessonVariable.Kind.COMPUTED,
                List.of(words.get(0)),
                List.copyOf(words.subList(1, words.size())),
                Optional.empty()));
    }

    /** {@code keep NAME FIELD SOURCE EVENT [TEST]...}: keeps the field of the latest such event. */
    private void keep(List<String> words, String rest) throws LessonException {
        String[] parts = rest.split("\\s+", 3);
        if (words.size() < 4) {
            throw new LessonException("expected keep NAME FIELD SOURCE EVENT [TEST]...");
        }
        variables.add(new LessonVariable(
                LessonVariable.Kind.KEPT,
                List.of(words.get(0)),
                List.of(words.get(1)),
                Optional.of(noted(EventPattern.parse(parts[2])))));
    }

    /** {@code action NAME [text|number RANGE|integer RANGE|file [ENDING]]}, RANGE as {@code 0..40}. */
    private void action(List<String> words) throws LessonException {
        require(!words.isEmpty() && words.size() <= 3, ACTION, String.join(" ", words));
        require(
                actions.stream().noneMatch(each -> each.name().equals(words.get(0))),
                "an action's name once",
                words.get(0));
        actions.add(new LessonAction(words.get(0), steps.size(), input(words.subList(1, words.size())), List.of()));
    }

    private static LessonAction.Input input(List<String> words) throws LessonException {
        String found = String.join(" ", words);
        Matcher range = RANGE.matcher(found);
        if (range.matches()) {
            int least = Integer.parseInt(range.group(2));
            int most = Integer.parseInt(range.group(3));
            require(least < most, "LEAST..MOST", range.group(2) + ".." + range.group(3));
            return new LessonAction.Range(least, most, range.group(1).equals("integer"));
        }
        if (!words.isEmpty() && words.get(0).equals("file")) {
            String ending = words.size() == 2 ? words.get(1) : "";
            require(ending.matches("[a-z0-9]*"), "the ending of a file without its dot", ending);
            return new LessonAction.File(ending);
        }
        require(words.isEmpty() || found.equals("text"), ACTION, found);
        return words.isEmpty() ? new LessonAction.Nothing() : new LessonAction.Text();
    }

    private void doing(String line) throws LessonException {
        if (actions.isEmpty()) {
            throw new LessonException("expected action NAME before do");
        }
        require(!line.equals("act") && !line.startsWith("act "), "a line that is no action itself", line);
        LessonAction last = actions.remove(actions.size() - 1);
        List<String> lines = new ArrayList<>(last.lines());
        lines.add(line);
        actions.add(new LessonAction(last.name(), last.stepsAbove(), last.input(), lines));
    }

    private EventPattern pattern(String text) throws LessonException {
        if (step == null) {
            throw new LessonException("expected step NAME before the first condition");
        }
        return noted(EventPattern.parse(text));
    }

    private EventPattern noted(EventPattern pattern) {
        patterns.put(number, pattern);
        return pattern;
    }

    private String inStep(String text) throws LessonException {
        require(step != null, "step NAME before it", "none");
        return text;
    }

    /** Requires that names in braces are variables; a program's options may use later ones. */
    private void requireKnownNames() throws LessonException {
        Set<String> known = new TreeSet<>(LessonVariables.PLACES);
        variables.forEach(variable -> known.addAll(variable.names()));
        for (Map.Entry<Integer, String> line : lines.entrySet()) {
            number = line.getKey();
            boolean isAct = line.getValue().strip().startsWith("do ");
            for (String used : LessonVariables.namesIn(line.getValue())) {
                boolean isInput = isAct && (used.equals("input") || used.equals("name"));
                require(isInput || known.contains(used), "in braces one of " + String.join(", ", known), used);
            }
        }
    }

    /** Requires that events are from programs of the lesson or common sources, and answers from steps. */
    private void requireKnownSources() throws LessonException {
        Set<String> known = new TreeSet<>(SOURCES);
        programs.forEach(program -> known.add(program.name()));
        Set<String> answers = new TreeSet<>();
        steps.forEach(each -> each.answer().ifPresent(answers::add));
        for (Map.Entry<Integer, EventPattern> each : patterns.entrySet()) {
            number = each.getKey();
            EventPattern pattern = each.getValue();
            require(known.contains(pattern.source()), "a source of " + String.join(", ", known), pattern.source());
            require(
                    !pattern.source().equals(LessonRun.STUDENT) || answers.contains(pattern.event()),
                    "an answer of " + String.join(", ", answers),
                    pattern.event());
        }
    }

    private static void require(boolean isMet, String expected, String found) throws LessonException {
        if (!isMet) {
            throw new LessonException("expected " + expected + "; found " + found);
        }
    }

    private void then(String text) throws LessonException {
        EventPattern next = pattern(text);
        LessonCondition last = conditions.isEmpty() ? null : conditions.remove(conditions.size() - 1);
        if (last == null
                || last.least() != 1
                || last.isLimit()
                || last.different().isPresent()) {
            throw new LessonException("expected when before then");
        }
        List<EventPattern> chain = new ArrayList<>(last.patterns());
        chain.add(next);
        conditions.add(LessonCondition.inOrder(List.copyOf(chain)));
    }

    /** {@code N [different FIELD] SOURCE EVENT [TEST]...}. */
    private LessonCondition counted(String text, boolean isLeast) throws LessonException {
        String[] parts = text.split("\\s+", 2);
        if (parts.length < 2) {
            throw new LessonException("expected a number and SOURCE EVENT [TEST]...");
        }
        int count = number(parts[0], 0, 99_999);
        String[] apart = parts[1].split("\\s+", 3);
        boolean isDifferent = apart[0].equals("different") && apart.length == 3;
        List<EventPattern> patterns = List.of(pattern(isDifferent ? apart[2] : parts[1]));
        Optional<String> different = isDifferent ? Optional.of(apart[1]) : Optional.empty();
        return isLeast
                ? new LessonCondition(patterns, count, LessonCondition.NO_LIMIT, different)
                : new LessonCondition(patterns, 0, count, different);
    }

    private void endStep() throws LessonException {
        if (step == null) {
            return;
        }
        if (conditions.isEmpty()) {
            throw new LessonException("expected at least one condition for step " + step);
        }
        steps.add(new LessonStep(step, after, again, answer, conditions));
        step = null;
        after = Optional.empty();
        again.clear();
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

    /** Items as a list in one line of a text file. */
    static List<String> list(String text) {
        return Arrays.stream(text.strip().split("\\s+"))
                .filter(word -> !word.isEmpty())
                .toList();
    }
}
