package simgsm.console;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class CommandTableTest {
    private final List<String> performed = new ArrayList<>();
    private final CommandTable<List<String>> table = new CommandTable<List<String>>(HelpRow.parse("""
            dial NUMBER
                calls the number
                es: llama al número
            answer
                answers the call that rings
            """))
            .add("dial", (list, command) -> list.add("dial " + command.rest()))
            .add("answer", (list, command) -> list.add("answer"));

    private void perform(String line) throws CommandException {
        table.perform(performed, ConsoleCommand.parse(line));
    }

    @Test
    void performsTheCommandOfTheName() throws Exception {
        perform("dial 5550200");
        perform("answer");
        assertEquals(List.of("dial 5550200", "answer"), performed);
    }

    @Test
    void anUnknownCommandIsAnErrorThatListsTheKnownOnes() {
        CommandException error = assertThrows(CommandException.class, () -> perform("call 1"));
        assertEquals("unknown command call, expected dial, answer, wait or quit", error.getMessage());
    }

    @Test
    void argumentsAfterACommandThatTakesNoneAreAnError() {
        CommandException error = assertThrows(CommandException.class, () -> perform("answer now"));
        assertEquals("answer: expected nothing after it, found now", error.getMessage());
        assertEquals(List.of(), performed);
    }

    @Test
    void aCommandHasOneRowAndOneAction() {
        assertThrows(IllegalArgumentException.class, () -> table.add("dial", (list, command) -> {}));
        assertThrows(IllegalArgumentException.class, () -> table.add("hold", (list, command) -> {}));
    }

    @Test
    void theReferenceNamesEachCommandItsArgumentsAndWhatItDoes() {
        List<String> lines = table.reference(false).lines().toList();
        assertEquals("  dial NUMBER                 calls the number", lines.get(0));
        assertEquals("  answer                      answers the call that rings", lines.get(1));
        assertTrue(lines.get(2).startsWith("  wait EVENT [key=value...] [SECONDS]"), lines.get(2));
        assertTrue(table.reference(true).startsWith("  dial NUMBER                 llama al número\n"));
    }

    @Test
    void theHelpOfAProgramEndsWithItsConsoleCommands() {
        String help = new Options("usage", "summary").commands(table).help(false);
        assertTrue(help.endsWith("\nConsole commands, with --headless:\n" + table.reference(false)), help);
    }
}
