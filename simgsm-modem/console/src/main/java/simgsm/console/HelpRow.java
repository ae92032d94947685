package simgsm.console;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * An option or a console command with its help, as a resource declares it: a line with the name and the arguments,
 * then indented lines of help, the Spanish ones after {@code es:}. A row without help is the shared row of that name,
 * if there is one; {@code include headless} stands for the rows of all programs with a console, {@code include
 * common} for those and the rows of all programs with a window.
 *
 * @param name with its hyphens
 * @param arguments as in a usage line; empty for none
 */
record HelpRow(String name, String arguments, String english, String spanish) {
    private static final String INCLUDE = "include";
    private static final String SPANISH = "es: ";
    private static final Map<String, HelpRow> SHARED =
            rows(HelpRow.class.getResourceAsStream("shared.txt"), Map.of()).stream()
                    .collect(Collectors.toMap(HelpRow::name, Function.identity()));

    /** The rows of a resource, which is closed. */
    static List<HelpRow> read(InputStream resource) {
        return rows(resource, SHARED);
    }

    /** The rows of a text. */
    static List<HelpRow> parse(String text) {
        return rows(text, SHARED);
    }

    /** The shared row of a name. */
    static HelpRow shared(String name) {
        return SHARED.get(name);
    }

    private static List<HelpRow> rows(InputStream resource, Map<String, HelpRow> shared) {
        try (resource) {
            return rows(new String(resource.readAllBytes(), StandardCharsets.UTF_8), shared);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static List<HelpRow> rows(String text, Map<String, HelpRow> shared) {
        List<HelpRow> rows = new ArrayList<>();
        for (String block : text.strip().split("\\R+(?=\\S)")) {
            List<String> lines = block.lines().toList();
            String[] head = lines.get(0).split(" ", 2);
            if (head[0].equals(INCLUDE)) {
                rows.addAll(read(HelpRow.class.getResourceAsStream(head[1] + ".txt")));
            } else {
                HelpRow row =
                        new HelpRow(head[0], head.length > 1 ? head[1] : "", help(lines, false), help(lines, true));
                rows.add(row.english.isEmpty() ? shared.getOrDefault(row.name, row) : row);
            }
        }
        return rows;
    }

    private static String help(List<String> lines, boolean inSpanish) {
        return lines.stream()
                .skip(1)
                .map(String::strip)
                .filter(line -> line.startsWith(SPANISH) == inSpanish)
                .map(line -> inSpanish ? line.substring(SPANISH.length()) : line)
                .collect(Collectors.joining("\n"));
    }

    String help(boolean inSpanish) {
        return inSpanish && !spanish.isEmpty() ? spanish : english;
    }

    /** Appends name, arguments and help in two columns. */
    void describe(StringBuilder text, boolean inSpanish) {
        String left = (name.startsWith("--") ? "      " : "  ") + (name + " " + arguments.replace(" ...", "")).strip();
        String column = " ".repeat(30);
        text.append(left.length() < column.length() - 1 ? left + column.substring(left.length()) : left + "\n" + column)
                .append(help(inSpanish).replace("\n", "\n" + column))
                .append('\n');
    }
}
