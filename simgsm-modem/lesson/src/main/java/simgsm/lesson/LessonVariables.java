package simgsm.lesson;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.regex.Pattern;
import simgsm.console.Event;

/** The values of names in braces: drawn from the seed, computed from others, or taken from events. */
final class LessonVariables {
    /** The lesson's working folder, and the folder of a teacher's own lesson. */
    static final Set<String> PLACES = Set.of("folder", "lesson");

    private static final Pattern IN_BRACES = Pattern.compile("\\{([A-Za-z][A-Za-z0-9-]*)\\}");

    private final Lesson lesson;
    private final LessonFunctions functions;
    private final Map<String, String> values = new HashMap<>();
    private final Set<String> drawn = new HashSet<>();

    LessonVariables(Lesson lesson, long seed, LessonFunctions functions) {
        this.lesson = lesson;
        this.functions = functions;
        SplittableRandom random = new SplittableRandom(seed);
        for (LessonVariable variable : lesson.variables()) {
            if (variable.kind() == LessonVariable.Kind.DRAWN) {
                draw(variable, random);
            }
        }
        compute();
    }

    /** The names in braces in a text. */
    static List<String> namesIn(String text) {
        return IN_BRACES.matcher(text).results().map(found -> found.group(1)).toList();
    }

    /** Names with values shown to students. */
    static Set<String> shownNames(Lesson lesson) {
        Set<String> names = new TreeSet<>(PLACES);
        lesson.variables().stream()
                .filter(variable -> variable.kind() == LessonVariable.Kind.DRAWN)
                .forEach(variable -> names.addAll(variable.names()));
        return names;
    }

    private void draw(LessonVariable variable, SplittableRandom random) {
        List<String> left = new ArrayList<>(variable.words());
        for (String name : variable.names()) {
            values.put(name, left.remove(random.nextInt(left.size())));
            drawn.add(name);
        }
    }

    /** Computes all functions with known arguments; the others remain open. */
    private void compute() {
        for (LessonVariable variable : lesson.variables()) {
            if (variable.kind() == LessonVariable.Kind.COMPUTED) {
                List<String> arguments = variable
                        .words()
                        .subList(1, variable.words().size())
                        .stream()
                        .map(word -> replace(word, true))
                        .toList();
                if (arguments.stream().noneMatch(word -> word.contains("{"))) {
                    values.put(variable.names().get(0), computed(variable, arguments));
                }
            }
        }
    }

    private String computed(LessonVariable variable, List<String> arguments) {
        try {
            return functions.apply(variable.words().get(0), arguments);
        } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
            throw new IllegalArgumentException(
                    lesson.name() + ": let " + variable.names().get(0) + " "
                            + variable.words().get(0) + " " + String.join(" ", arguments) + ": " + e.getMessage(),
                    e);
        }
    }

    /** Takes the kept values from this event. */
    void take(String source, Event event) {
        boolean isChanged = false;
        for (LessonVariable variable : lesson.variables()) {
            if (variable.kind() == LessonVariable.Kind.KEPT
                    && variable.pattern().orElseThrow().matches(source, event, text -> replace(text, true))) {
                String value = event.fields().get(variable.words().get(0));
                if (value != null) {
                    values.put(variable.names().get(0), value);
                    isChanged = true;
                }
            }
        }
        if (isChanged) {
            compute();
        }
    }

    void put(String name, String value) {
        values.put(name, value);
        drawn.add(name);
        compute();
    }

    /**
     * Replaces the known names in braces.
     *
     * @param isAll true to replace the solution's values, too
     */
    String replace(String text, boolean isAll) {
        String replaced = text;
        for (Map.Entry<String, String> entry : values.entrySet()) {
            if (isAll || drawn.contains(entry.getKey())) {
                replaced = replaced.replace("{" + entry.getKey() + "}", entry.getValue());
            }
        }
        return replaced;
    }

    /** The student's own numbers: the drawn values without folders. */
    Map<String, String> drawn() {
        Map<String, String> shown = new HashMap<>(values);
        shown.keySet().retainAll(drawn);
        shown.keySet().removeAll(PLACES);
        return Collections.unmodifiableMap(shown);
    }
}
