package simgsm.lesson;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import simgsm.console.Event;

/** The values of names in braces: drawn from the seed, computed from others, or taken from events. */
final class LessonVariables {
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

    private void draw(LessonVariable variable, SplittableRandom random) {
        List<String> left = new ArrayList<>(variable.words());
        for (String name : variable.names()) {
            values.put(name, left.remove(random.nextInt(left.size())));
            drawn.add(name);
        }
    }

    /** Computes what can be: a function whose arguments are not known yet waits for them. */
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
                    values.put(
                            variable.names().get(0),
                            functions.apply(variable.words().get(0), arguments));
                }
            }
        }
    }

    /** Takes the values that conditions keep from this event. */
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
     * @param isAll whether the values of the solution are replaced, too
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

    /** The drawn values, for the result. */
    Map<String, String> drawn() {
        Map<String, String> shown = new HashMap<>(values);
        shown.keySet().retainAll(drawn);
        return Collections.unmodifiableMap(shown);
    }
}
