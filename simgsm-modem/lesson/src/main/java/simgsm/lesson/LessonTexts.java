package simgsm.lesson;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The texts of a lesson in one language. A line {@code KEY: text} begins one, such as {@code step dial: Dial the
 * robot.}; indented lines continue it, and an empty line in it begins a paragraph.
 */
public final class LessonTexts {
    private final String file;
    private final Map<String, String> texts;
    /** Line number of each key. */
    private final Map<String, Integer> lines;

    private LessonTexts(String file, Map<String, String> texts, Map<String, Integer> lines) {
        this.file = file;
        this.texts = texts;
        this.lines = lines;
    }

    /** @param file for error texts, such as {@code twelve-keys/en.txt} */
    static LessonTexts read(String file, String content) throws LessonException {
        Map<String, List<String>> read = new LinkedHashMap<>();
        Map<String, Integer> lines = new HashMap<>();
        List<String> current = null;
        int number = 0;
        for (String line : content.lines().toList()) {
            number++;
            if (line.startsWith("#")) {
                continue;
            }
            if (line.isBlank() || Character.isWhitespace(line.charAt(0))) {
                if (current != null) {
                    current.add(line.strip());
                }
                continue;
            }
            int colon = line.indexOf(':');
            if (colon <= 0) {
                throw new LessonException(file + ", line " + number + ": expected KEY: text, found " + line);
            }
            current = new ArrayList<>(List.of(line.substring(colon + 1).strip()));
            String key = line.substring(0, colon).strip();
            lines.put(key, number);
            if (read.put(key, current) != null) {
                throw new LessonException(
                        file + ", line " + number + ": expected each key once, found " + key + " for the second time");
            }
        }
        Map<String, String> texts = new LinkedHashMap<>();
        read.forEach((key, parts) -> texts.put(key, joined(parts)));
        return new LessonTexts(file, texts, lines);
    }

    /**
     * Requires a text for each part of the lesson and no other, with no other names in braces than the student's own.
     *
     * @throws LessonException naming file, line and expected form
     */
    void require(Lesson lesson) throws LessonException {
        Set<String> keys = new LinkedHashSet<>(List.of("title", "task", "predict", "question"));
        lesson.steps().forEach(step -> keys.addAll(List.of("step " + step.name(), "hint " + step.name())));
        lesson.actions().forEach(action -> keys.add("action " + action.name()));
        Set<String> others = new LinkedHashSet<>(Set.of("about"));
        lesson.programs()
                .forEach(program -> others.addAll(List.of("program " + program.name(), "refused " + program.name())));
        lesson.actions().forEach(action -> others.add("refused " + action.name()));
        for (String key : texts.keySet()) {
            if (!keys.contains(key) && !others.contains(key)) {
                throw new LessonException(file + ", line " + lines.get(key) + ": expected a key of "
                        + String.join(", ", keys) + "; found " + key);
            }
        }
        Set<String> shown = LessonVariables.shownNames(lesson);
        for (String key : keys) {
            String text = texts.getOrDefault(key, "");
            if (text.isBlank()) {
                throw new LessonException(file + (lines.containsKey(key) ? ", line " + lines.get(key) : "")
                        + ": expected " + key + ": text");
            }
            for (String name : LessonVariables.namesIn(text)) {
                if (!shown.contains(name)) {
                    throw new LessonException(file + ", line " + lines.get(key) + ": " + key
                            + ": expected in braces one of " + String.join(", ", shown) + "; found " + name);
                }
            }
        }
    }

    /** Joins lines of a paragraph by blanks, paragraphs by an empty line. */
    private static String joined(List<String> lines) {
        StringBuilder text = new StringBuilder();
        for (String line : lines) {
            if (line.isEmpty()) {
                text.append("\n\n");
            } else {
                text.append(text.length() == 0 || text.charAt(text.length() - 1) == '\n' ? "" : " ")
                        .append(line);
            }
        }
        return text.toString().strip();
    }

    /** The text; the key if there is none. */
    public String of(String key) {
        return texts.getOrDefault(key, key);
    }

    public Optional<String> find(String key) {
        return Optional.ofNullable(texts.get(key));
    }

    public Set<String> keys() {
        return Collections.unmodifiableSet(texts.keySet());
    }
}
