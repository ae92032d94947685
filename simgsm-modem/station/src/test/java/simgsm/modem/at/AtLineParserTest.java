package simgsm.modem.at;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class AtLineParserTest {
    private static String commandsOf(String line) throws AtException {
        AtLineParser parser = new AtLineParser(line);
        List<String> commands = new ArrayList<>();
        while (parser.hasNext()) {
            AtCommand command = parser.next();
            commands.add((command.name() + " " + command.form() + " " + command.parameters()).strip());
        }
        return String.join(" / ", commands);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '>', quoteCharacter = '~', textBlock = """
            e0v1                > E EXECUTE 0 / V EXECUTE 1
            &f&v                > &F EXECUTE / &V EXECUTE
            Z E 1               > Z EXECUTE / E EXECUTE 1
            S3?S4=10            > S EXECUTE 3? / S EXECUTE 4=10
            S 3 = 13            > S EXECUTE 3=13
            S0                  > S EXECUTE 0
            DT555 0100;         > D EXECUTE T555 0100;
            D1;H                > D EXECUTE 1; / H EXECUTE
            D"a;b";E1           > D EXECUTE "a;b"; / E EXECUTE 1
            +csq                > +CSQ EXECUTE
            +CSQ=?;+CREG?       > +CSQ TEST / +CREG READ
            +CREG=2;E0          > +CREG SET 2 / E EXECUTE 0
            E0+CMEE = 2 ;; H    > E EXECUTE 0 / +CMEE SET 2 / H EXECUTE
            +CPBW=1,"5;5",129   > +CPBW SET 1,"5;5",129
            +COPS= ?            > +COPS TEST
            +CMGS=              > +CMGS SET
            ^x:y/Z1=1           > ^X:Y/Z1 SET 1
            """)
    void aLineIsCutIntoItsCommands(String line, String commands) throws AtException {
        assertEquals(commands, commandsOf(line));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "   ", ";", " ; ;"})
    void aLineMayHaveNoCommand(String line) {
        assertFalse(new AtLineParser(line).hasNext());
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "&", "&1", "+", "+=1", "\"", "=?", "+CSQ \"1\"", "\u00e9"})
    void whatIsNoCommandIsAnError(String line) {
        AtLineParser parser = new AtLineParser(line);
        assertTrue(parser.hasNext());
        assertEquals(
                AtResult.ERROR, assertThrows(AtException.class, parser::next).result());
    }

    @Test
    void theCommandsBeforeAFaultAreRead() throws AtException {
        AtLineParser parser = new AtLineParser("E0?");
        assertEquals("0", parser.next().parameters());
        assertThrows(AtException.class, parser::next);
    }
}
