package blackbox;

import org.junit.jupiter.api.Test;
import simgsm.modem.at.command.AtCommands;

/** {@code docs/AT-COMMANDS.md} holds the table of AT commands. */
class AtManualTest {
    private static final String HEAD = """
            # All AT commands

            Printed by the command table of the phone and of M2; a test compares. In parentheses the value at the start of a connection. How clients are
            attached is in [AT commands](AT.md).

            """;

    @Test
    void thePageHoldsTheCommandTable() throws Exception {
        PrintedFile.hold(Dist.root().resolve("docs/AT-COMMANDS.md"), HEAD + AtCommands.toMarkdown());
    }
}
