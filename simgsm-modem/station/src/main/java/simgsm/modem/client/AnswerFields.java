package simgsm.modem.client;

import java.util.List;
import simgsm.modem.at.AtParameters;

/** The values of a line such as {@code +CLCC: 1,1,4,0,0,"5550100",129}, without quotes. */
record AnswerFields(List<String> values) {
    static AnswerFields of(String line) {
        return new AnswerFields(AtParameters.split(line.substring(line.indexOf(':') + 1)));
    }

    /** The value at a place, without quotes; empty if there is none. */
    String text(int index) {
        return index < values.size() ? values.get(index).replace("\"", "") : "";
    }

    /** A number; -1 if there is none. */
    int number(int index) {
        return text(index).matches("[0-9]{1,9}") ? Integer.parseInt(text(index)) : -1;
    }

    /** The quoted value at this index among the quoted ones; empty if there is none. */
    String quoted(int rank) {
        return values.stream()
                .filter(value -> value.startsWith("\""))
                .skip(rank)
                .findFirst()
                .map(value -> value.replace("\"", ""))
                .orElse("");
    }
}
