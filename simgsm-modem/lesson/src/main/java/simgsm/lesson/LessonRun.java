package simgsm.lesson;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import simgsm.console.Event;

/** One student's run of a lesson, which marks steps as done by events. One thread at a time. */
public final class LessonRun {
    /** The source of the student's answers; the event's name is the answer's. */
    public static final String STUDENT = "student";

    private final Lesson lesson;
    private final long seed;
    private final LessonVariables variables;
    private final List<Progress> steps = new ArrayList<>();
    private final Map<String, String> answers = new LinkedHashMap<>();
    private String prediction = "";
    private Consumer<StepResult> listener = result -> {};

    /** @param seed selects the student's own numbers */
    public LessonRun(Lesson lesson, long seed, LessonFunctions functions) {
        this.lesson = lesson;
        this.seed = seed;
        variables = new LessonVariables(lesson, seed, functions);
        lesson.steps().forEach(step -> steps.add(new Progress(step)));
    }

    public Lesson lesson() {
        return lesson;
    }

    public long seed() {
        return seed;
    }

    /** Tells of each step that is done, and of each answer that is not right, as it happens. */
    public void listen(Consumer<StepResult> next) {
        listener = next;
    }

    /** Sets a value for the task's text, such as a folder. */
    public void put(String name, String value) {
        variables.put(name, value);
    }

    /** The student's prediction, not marked. Only the first is kept: later ones would not be predictions. */
    public void predict(String text) {
        if (prediction.isEmpty()) {
            prediction = text.strip();
        }
    }

    public String prediction() {
        return prediction;
    }

    /** An answer in the student's words; its numbers, or else its words, are the fields n1, n2 ... */
    public void answer(String name, String text) {
        if (steps.stream().anyMatch(each -> each.isDone && each.step.answer().equals(Optional.of(name)))) {
            return; // a right answer stays
        }
        answers.put(name, text.strip());
        Event event = Event.of(name).with("text", octets(text.strip()));
        List<String> words = words(text);
        for (int i = 0; i < words.size(); i++) {
            event = event.with("n" + (i + 1), words.get(i));
        }
        event(STUDENT, event.with("count", words.size()));
    }

    /** An answer without Wireshark's separators and prefixes of octets: {@code 55:05}, {@code 0x03}. */
    private static String octets(String text) {
        return text.replaceAll("(?i)\\b0x(?=[0-9a-f])", "")
                .replaceAll("(?i)(?<=\\b[0-9a-f]{2}):(?=[0-9a-f]{2}\\b)", "");
    }

    /**
     * The words of an answer; if it has numbers only these, so units and conjunctions are permitted: {@code 697 Hz
     * and 1209 Hz}, {@code 697,1209} and {@code 697/1209} are two numbers, {@code -9,5 dB} is one.
     */
    private static List<String> words(String text) {
        String parted = text.replace('\u2212', '-')
                .replaceAll("[;/]", " ")
                .replaceAll("(?<=[0-9])[+]", " ")
                .replaceAll("(?<=[0-9]{3}),(?=[0-9]{3})", " ");
        List<String> words = LessonReader.list(parted).stream()
                .map(word -> word.replaceAll("[,:.]$", "").replaceAll("^([-+]?[0-9]+([.,][0-9]+)?)\\p{L}+$", "$1"))
                .toList();
        List<String> numbers =
                words.stream().filter(word -> word.matches(".*[0-9].*")).toList();
        return numbers.isEmpty() ? words : numbers;
    }

    /** An event printed by a program. */
    public void event(String source, Event event) {
        variables.take(source, event);
        // A step opened by this event begins with the next one.
        List<Progress> open = steps.stream().filter(this::isOpen).toList();
        open.forEach(step -> step.event(source, event));
    }

    private boolean isOpen(Progress progress) {
        return progress.step.after().map(this::isDone).orElse(true);
    }

    private Progress progress(String name) {
        return steps.stream()
                .filter(each -> each.step.name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    /** True if all conditions of a step hold. */
    public boolean isDone(String name) {
        return progress(name).isDone;
    }

    /** True if a limit of a step is exceeded, so that only a new try can pass it, or a new run where it has no tries. */
    public boolean isExceeded(String name) {
        return progress(name).isExceeded();
    }

    /** The student opens the hint of a step. */
    public void hint(String name) {
        Progress progress = progress(name);
        progress.hints = progress.isDone ? progress.hints : 1;
    }

    /** The current result of a step. */
    public StepResult result(String name) {
        return progress(name).result();
    }

    /** Returns a count such as {@code 2/3} for each condition of the step that counts, except those that allow none. */
    public List<String> counts(String name) {
        return progress(name).counted();
    }

    public int score() {
        return (int) steps.stream().filter(each -> each.isDone).count();
    }

    /** The newest text of each answer, in the order of their first texts. */
    public Map<String, String> answers() {
        return Collections.unmodifiableMap(answers);
    }

    /** The student's own numbers. */
    public Map<String, String> drawn() {
        return variables.drawn();
    }

    /** A text of the task with the student's own numbers. */
    public String shown(String text) {
        return variables.replace(text, false);
    }

    /** A text of the lesson's solutions, with the values that the student has to find. */
    public String solved(String text) {
        return variables.replace(text, true);
    }

    private final class Progress {
        private final LessonStep step;
        /** Matched patterns or counted events, by condition. */
        private final int[] counts;
        /** Counted values, by condition. */
        private final Map<LessonCondition, Set<String>> values = new HashMap<>();

        /** A step remains done. */
        private boolean isDone;

        private int tries;
        private int hints;

        Progress(LessonStep step) {
            this.step = step;
            counts = new int[step.conditions().size()];
        }

        void event(String source, Event event) {
            if (isDone) {
                return;
            }
            boolean isAnswer = source.equals(STUDENT) && step.answer().equals(Optional.of(event.name()));
            if (step.again().stream().anyMatch(each -> each.matches(source, event, LessonRun.this::solved))) {
                tries += Arrays.stream(counts).anyMatch(count -> count > 0) ? 1 : 0;
                Arrays.fill(counts, 0);
                values.clear();
            }
            count(source, event);
            isDone = areAllMet();
            if (isDone || isAnswer) {
                tries++;
                listener.accept(result());
            }
        }

        private void count(String source, Event event) {
            for (int i = 0; i < counts.length; i++) {
                LessonCondition condition = step.conditions().get(i);
                List<EventPattern> chain = condition.patterns();
                int next = chain.size() == 1 ? 0 : counts[i];
                if (next < chain.size()
                        && chain.get(next).matches(source, event, LessonRun.this::solved)
                        && isNew(condition, event)) {
                    counts[i]++;
                }
            }
        }

        private boolean isNew(LessonCondition condition, Event event) {
            return condition
                    .different()
                    .map(field -> FieldTest.plain(event.fields().getOrDefault(field, "")))
                    .map(values.computeIfAbsent(condition, key -> new HashSet<>())::add)
                    .orElse(true);
        }

        private boolean areAllMet() {
            for (int i = 0; i < counts.length; i++) {
                LessonCondition condition = step.conditions().get(i);
                int wanted = condition.patterns().size() == 1
                        ? condition.least()
                        : condition.patterns().size();
                if (counts[i] < wanted || counts[i] > condition.most()) {
                    return false;
                }
            }
            return true;
        }

        boolean isExceeded() {
            return !isDone
                    && IntStream.range(0, counts.length)
                            .anyMatch(i -> counts[i] > step.conditions().get(i).most());
        }

        StepResult result() {
            return new StepResult(lesson.name(), step.name(), isDone, tries, hints);
        }

        List<String> counted() {
            List<String> counted = new ArrayList<>();
            for (int i = 0; i < counts.length; i++) {
                LessonCondition condition = step.conditions().get(i);
                int bound = condition.isLimit() ? condition.most() : condition.least();
                if (condition.patterns().size() == 1 && bound > (condition.isLimit() ? 0 : 1)) {
                    counted.add(counts[i] + "/" + bound);
                }
            }
            return counted;
        }
    }
}
