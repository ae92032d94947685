package simgsm.modem.client;

import java.util.ArrayList;
import java.util.List;

/** The values of a line such as {@code +CLCC: 1,1,4,0,0,"5550100",129}, without quotes. */
record AnswerFields(List<String> values) {
    static AnswerFields of(String line) {
        String rest = line.substring(line.indexOf(':') + 1);
        List<String> values = new ArrayList<>();
        StringBuilder value = new StringBuilder();
        boolean quoted = false;
        for (char character : rest.toCharArray()) {
            if (character == '"') {
                quoted = !quoted;
                value.append(character);
            } else if (character == ',' && !quoted) {
                values.add(value.toString().strip());
                value.setLength(0);
            } else {
                value.append(character);
            }
        }
        values.add(value.toString().strip());
        return new AnswerFields(List.copyOf(values));
    }

    /** The value at a place, without quotes; empty if there is none. */
    String text(int index) {
        return index < values.size() ? values.get(index).replace("\"", "") : "";
    }

    /** A number; -1 if there is none. */
    int number(int index) {
        return text(index).matches("[0-9]{1,9}") ? Integer.parseInt(text(index)) : -1;
    }

    /** The value in quotes of this rank; empty if there is none. */
    String quoted(int rank) {
        return values.stream()
                .filter(value -> value.startsWith("\""))
                .skip(rank)
                .findFirst()
                .map(value -> value.replace("\"", ""))
                .orElse("");
    }
}
