package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simgsm.modem.at.command.AtCommands;

/** {@code docs/REFERENCE.md} holds what every program and tool prints for {@code --help}, and the table of AT commands. */
class ReferenceTest {
    private static final String HEAD = """
            # Reference

            Printed by the programs themselves (`--help`); a test compares. The events of the consoles are in [Console](CONSOLE.md).
            """;

    private static final String AT_HEAD = """

            ## AT commands

            Printed by the command table of the phone and of M2. In parentheses the value at the start of a connection. How clients are
            attached is in [AT commands](AT.md).

            """;

    private static final List<String> TOOLS = List.of("tones", "decode", "gsm", "pdu", "load", "fuzz");

    @Test
    void thePageHoldsWhatTheProgramsPrint() throws Exception {
        StringBuilder page = new StringBuilder(HEAD);
        for (String program :
                List.of("simgsm-center", "simgsm-cells", "simgsm-phone", "simrobot", "vericommand", "simgsm-modem")) {
            append(page, program, List.of());
        }
        for (String tool : TOOLS) {
            append(page, "simgsm-modem", List.of(tool));
        }
        page.append(AT_HEAD).append(AtCommands.toMarkdown());
        PrintedFile.hold(Dist.root().resolve("docs/REFERENCE.md"), page.toString());
    }

    private static void append(StringBuilder page, String program, List<String> words) throws Exception {
        List<String> arguments = new ArrayList<>(words);
        arguments.add("--help");
        FinishedProgram help = FinishedProgram.run(program, arguments.toArray(String[]::new));
        assertEquals(0, help.status(), help.error());
        page.append("\n## ").append(program).append(".jar");
        words.forEach(word -> page.append(' ').append(word));
        page.append("\n\n```\n").append(help.output().stripTrailing()).append("\n```\n");
    }
}
