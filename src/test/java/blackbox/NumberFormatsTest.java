package blackbox;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** In some of the system's languages the default locale has other digits, or a comma for the decimal point. */
class NumberFormatsTest {
    private static final String LITERAL = "(\"(?:[^\"\\\\\n]++|\\\\.)*+\")";
    private static final Pattern WITHOUT_LOCALE =
            Pattern.compile("(?:String\\.format|printf)\\(\\s*" + LITERAL + "|" + LITERAL + "\\s*\\.formatted\\(");
    /** Hexadecimal digits and texts are the same in every locale. */
    private static final Pattern NUMBER = Pattern.compile("%[-+ 0,(#]*[0-9]*(?:\\.[0-9]+)?[deEfgG]");

    @Test
    void numbersAreFormattedWithALocale() {
        assertEquals(
                List.of(),
                MainCode.sources().stream()
                        .flatMap(NumberFormatsTest::withoutLocale)
                        .toList());
    }

    private static Stream<String> withoutLocale(Path file) {
        return WITHOUT_LOCALE
                .matcher(MainCode.read(file))
                .results()
                .map(found -> found.group(1) == null ? found.group(2) : found.group(1))
                .filter(format -> NUMBER.matcher(format).find())
                .map(format -> file.getFileName() + ": " + format);
    }
}
