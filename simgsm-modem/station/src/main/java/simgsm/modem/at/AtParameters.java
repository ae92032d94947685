package simgsm.modem.at;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The parameters of a command, separated by commas; quotation marks around texts are optional. An omitted parameter
 * is empty. An invalid one ends the command with +CME ERROR: 50, or the result of {@link #refusing}.
 */
public final class AtParameters {
    private final List<String> values;
    private final AtResult refusal;

    private AtParameters(List<String> values, AtResult refusal) {
        this.values = values;
        this.refusal = refusal;
    }

    /** @throws AtException for an unpaired quotation mark, or one inside a value */
    static AtParameters of(String text) throws AtException {
        AtResult refusal = new AtResult.EquipmentError(CmeError.INCORRECT_PARAMETERS);
        List<String> values = new ArrayList<>();
        for (String raw : split(text)) {
            values.add(value(raw, refusal));
        }
        return new AtParameters(text.isEmpty() ? List.of() : values, refusal);
    }

    /** Splits at commas outside quotation marks, which are kept; at least one value. */
    public static List<String> split(String text) {
        List<String> values = new ArrayList<>();
        int start = 0;
        boolean quoted = false;
        for (int i = 0; i <= text.length(); i++) {
            boolean ends = i == text.length() || !quoted && text.charAt(i) == ',';
            if (ends) {
                values.add(text.substring(start, i).strip());
                start = i + 1;
            } else {
                quoted ^= text.charAt(i) == '"';
            }
        }
        return values;
    }

    private static String value(String raw, AtResult refusal) throws AtException {
        if (raw.indexOf('"') < 0) {
            return raw;
        }
        if (raw.length() < 2 || raw.indexOf('"') != 0 || raw.indexOf('"', 1) != raw.length() - 1) {
            throw new AtException(refusal);
        }
        return raw.substring(1, raw.length() - 1);
    }

    /** A copy that ends the command with this result if a parameter is invalid. */
    public AtParameters refusing(AtResult result) {
        return new AtParameters(values, result);
    }

    public int count() {
        return values.size();
    }

    public AtParameters atMost(int count) throws AtException {
        if (values.size() > count) {
            throw refused();
        }
        return this;
    }

    public AtException refused() {
        return new AtException(refusal);
    }

    /** A text; empty if omitted. */
    public String text(int index) {
        return index < values.size() ? values.get(index) : "";
    }

    public Optional<String> given(int index) {
        return text(index).isEmpty() ? Optional.empty() : Optional.of(text(index));
    }

    /** A required number. */
    public int number(int index, int least, int most) throws AtException {
        String text = text(index);
        if (text.isEmpty() || text.length() > 9 || !text.chars().allMatch(sign -> sign >= '0' && sign <= '9')) {
            throw refused();
        }
        int number = Integer.parseInt(text);
        if (number < least || number > most) {
            throw refused();
        }
        return number;
    }

    /** An optional number. */
    public int number(int index, int least, int most, int otherwise) throws AtException {
        return text(index).isEmpty() ? otherwise : number(index, least, most);
    }
}
