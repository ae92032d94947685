package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code --help --lang es} prints every option and console command in Spanish. */
class SpanishHelpTest {
    @ParameterizedTest
    @ValueSource(strings = {"simgsm-center", "simgsm-cells", "simgsm-gateway", "simgsm-phone", "simrobot"})
    void everyRowOfTheHelpHasASpanishText(String program) throws Exception {
        List<String> english = rows(program, "en");
        List<String> spanish = rows(program, "es");
        assertTrue(spanish.get(0).startsWith("Uso: java -jar " + program + ".jar "), spanish.get(0));
        assertEquals(english.size(), spanish.size());
        spanish.retainAll(english);
        assertEquals(List.of(), spanish);
    }

    /** Rows with their further lines, which are indented by 30 blanks. */
    private static List<String> rows(String program, String language) throws Exception {
        FinishedProgram help = FinishedProgram.run(program, "--help", "--lang", language);
        assertEquals(0, help.status(), help.error());
        List<String> rows = new ArrayList<>(List.of(help.output().split("\n(?! {10})")));
        rows.removeIf(String::isBlank);
        return rows;
    }
}
