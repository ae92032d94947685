package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import simgsm.modem.at.command.AtCommands;

/** {@code docs/REFERENCE.md} holds what every program and tool prints for {@code --help}, and the list of AT commands. */
class ReferenceTest {
    private static final String HEAD = """
            # Reference

            Printed by the programs themselves (`--help`); a test compares. The events of the consoles are in [Console](CONSOLE.md).

            ## All programs with a window

            Options and console commands that centre, cells, phone and SimRobot share; the other sections leave them out.

            ```
            """;

    private static final String AT_HEAD = """

            ## AT commands

            Printed by the command table of the phone and of M2. In parentheses the value at the start of a connection. How clients are
            attached is in [AT commands](AT.md).

            """;

    private static final List<String> WINDOWED = List.of("simgsm-center", "simgsm-cells", "simgsm-phone", "simrobot");
    private static final List<String> TOOLS = List.of("tones", "decode", "gsm", "pdu", "load");
    /** A new entry begins at a line that is indented by two or six blanks; its other lines are indented further. */
    private static final Pattern ENTRIES = Pattern.compile("\n(?! {10})");

    @Test
    void thePageHoldsWhatTheProgramsPrint() throws Exception {
        Map<String, List<String>> helps = new LinkedHashMap<>();
        for (String program : WINDOWED) {
            helps.put(program, entries(help(program, List.of())));
        }
        Set<String> shared = new LinkedHashSet<>(helps.get(WINDOWED.get(0)));
        helps.values().forEach(shared::retainAll);
        shared.removeIf(entry -> !entry.startsWith("  "));
        StringBuilder page = new StringBuilder(HEAD);
        page.append(String.join("\n", shared)).append("\n```\n");
        for (String program : WINDOWED) {
            append(page, program, List.of(), without(shared, helps.get(program)));
        }
        for (String program : List.of("simgsm-gateway", "vericommand", "simgsm-modem")) {
            append(page, program, List.of(), without(shared, entries(help(program, List.of()))));
        }
        for (String tool : TOOLS) {
            append(page, "simgsm-modem", List.of(tool), without(shared, entries(help("simgsm-modem", List.of(tool)))));
        }
        page.append(AT_HEAD).append(AtCommands.toMarkdown());
        PrintedFile.hold(Dist.root().resolve("docs/REFERENCE.md"), page.toString());
    }

    private static String without(Set<String> shared, List<String> entries) {
        List<String> own = new ArrayList<>(entries);
        own.removeAll(shared);
        return String.join("\n", own).stripTrailing().replaceFirst("\n+Options:$", "");
    }

    private static List<String> entries(String help) {
        return List.of(ENTRIES.split(help));
    }

    private static String help(String program, List<String> words) throws Exception {
        List<String> arguments = new ArrayList<>(words);
        arguments.add("--help");
        FinishedProgram help = FinishedProgram.run(program, arguments.toArray(String[]::new));
        assertEquals(0, help.status(), help.error());
        return help.output().stripTrailing();
    }

    private static void append(StringBuilder page, String program, List<String> words, String help) {
        page.append("\n## ").append(program).append(".jar");
        words.forEach(word -> page.append(' ').append(word));
        page.append("\n\n```\n").append(help).append("\n```\n");
    }
}
