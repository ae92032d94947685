package simgsm.center.ui.ladder;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Selects the messages of the ladder.
 *
 * @param terminal sender or receiver; empty for all
 * @param kind protocol; empty for all
 * @param text part of name, numbers, fields in either language or octets (as {@code 5e 08}), in any case; empty for all
 */
record LadderFilter(Optional<String> terminal, Optional<Protocol> kind, String text) {
    static final LadderFilter ALL = new LadderFilter(Optional.empty(), Optional.empty(), "");

    LadderFilter {
        text = text.strip().toLowerCase(Locale.ROOT);
    }

    boolean accepts(LadderRow row) {
        return (terminal.isEmpty() || terminal.get().equals(row.terminal()))
                && (kind.isEmpty() || kind.get() == Protocol.of(row.entry()))
                && (text.isEmpty() || has(row));
    }

    private boolean has(LadderRow row) {
        if (row.toString().toLowerCase(Locale.ROOT).contains(text)) {
            return true;
        }
        return row.entry().octets().toString().contains(text.replace(" ", ""))
                || Stream.of(Locale.ENGLISH, Locale.forLanguageTag("es"))
                        .flatMap(language -> MessageFields.of(row, language).fields().stream())
                        .anyMatch(field ->
                                field.toString().toLowerCase(Locale.ROOT).contains(text));
    }
}
