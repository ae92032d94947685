package simgsm.lesson;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The texts of a lesson in one language. In the file a line {@code KEY: text} begins one, such as {@code step dial: Dial the
 * robot.}; indented lines continue it, and an empty line in it begins a paragraph.
 */
public final class LessonTexts {
    private final Map<String, String> texts;

    private LessonTexts(Map<String, String> texts) {
        this.texts = texts;
    }

    /** @param file for the messages, such as {@code twelve-keys/en.txt} */
    static LessonTexts read(String file, String content) throws LessonException {
        Map<String, List<String>> read = new LinkedHashMap<>();
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
            if (read.put(line.substring(0, colon).strip(), current) != null) {
                throw new LessonException(
                        file + ", line " + number + ": " + line.substring(0, colon) + " stands twice");
            }
        }
        Map<String, String> texts = new LinkedHashMap<>();
        read.forEach((key, lines) -> texts.put(key, joined(lines)));
        return new LessonTexts(texts);
    }

    /** Lines of a paragraph are joined by blanks, paragraphs by an empty line. */
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

    /** The text, or the key where there is none. */
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
