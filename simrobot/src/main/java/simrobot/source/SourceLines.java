package simrobot.source;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/** The lines of a source file, searched for the place of a fault which compiler and child do not know. */
record SourceLines(List<String> lines) {
    /** Probable text of the student, by the cause of the fault. */
    private static final Map<String, Pattern> LIKELY = Map.of(
            "halt", Pattern.compile("\\b(halt|exit)\\s*\\("),
            "null", Pattern.compile("\\breturn\\s+null\\b"),
            "process", Pattern.compile("\\b(class|interface)\\s"));

    private static final Pattern TEXTS = Pattern.compile("\"(\\\\.|[^\"])*\"|'(\\\\.|[^'])+'|//.*");

    static SourceLines of(String source) {
        return new SourceLines(source.lines().toList());
    }

    /** Returns the number of the first line that probably has this fault; 0 if there is none. */
    int likely(String cause) {
        return IntStream.range(0, LIKELY.containsKey(cause) ? lines.size() : 0)
                .filter(i -> LIKELY.get(cause).matcher(lines.get(i)).find())
                .map(i -> i + 1)
                .findFirst()
                .orElse(0);
    }

    /**
     * Returns the line of the opening brace that has no closing one: the first one for which the next closing brace stands
     * further to the left than its line does, else the last one. 0 if each has its closing one.
     */
    int unclosed() {
        Deque<Integer> open = new ArrayDeque<>();
        for (int i = 0; i < lines.size(); i++) {
            String code = TEXTS.matcher(lines.get(i)).replaceAll("");
            boolean isLeft = !open.isEmpty() && code.strip().startsWith("}") && indent(i) < indent(open.peek());
            if (isLeft) {
                return open.peek() + 1;
            }
            for (char each : code.toCharArray()) {
                if (each == '{') {
                    open.push(i);
                } else if (each == '}') {
                    open.poll();
                }
            }
        }
        return open.isEmpty() ? 0 : open.peek() + 1;
    }

    private int indent(int line) {
        return lines.get(line).length() - lines.get(line).stripLeading().length();
    }
}
