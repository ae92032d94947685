package simgsm.file;

import java.util.List;
import java.util.stream.Collectors;

/** Lines of CSV files (RFC 4180). A record is one line, for tools that read lines. */
public final class CsvLine {
    private CsvLine() {}

    /** The line, without its end. */
    public static String of(List<String> fields) {
        return fields.stream().map(CsvLine::field).collect(Collectors.joining(","));
    }

    /** Quotes a field with a comma or a quote. A text that a spreadsheet would compute gets an apostrophe. */
    private static String field(String text) {
        boolean isFormula = text.matches("(?s)[=+@\t\r-].*");
        String safe = (isFormula ? "'" : "") + LineText.escaped(text);
        return safe.matches(".*[\",].*") ? '"' + safe.replace("\"", "\"\"") + '"' : safe;
    }
}
