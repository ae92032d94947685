package simgsm.modem.client;

import java.util.List;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The end of a command.
 *
 * @param lines before the final result
 * @param result the final result as received; empty if there was none
 */
record ModemAnswer(Ending ending, List<String> lines, String result) {
    enum Ending {
        OK,
        /** ERROR, {@code +CME ERROR}, {@code +CMS ERROR}, or the call's end. */
        REFUSED,
        /** No final result in time. */
        TIMED_OUT,
        /** The modem was lost or has restarted. */
        LOST
    }

    static final ModemAnswer LOST = new ModemAnswer(Ending.LOST, List.of(), "");

    boolean isOk() {
        return ending == Ending.OK;
    }

    /** The number of a {@code +CMS ERROR} or {@code +CME ERROR}. */
    OptionalInt errorNumber() {
        String number = result.replaceFirst("^\\+CM[SE] ERROR: *", "");
        return number.matches("[0-9]{1,4}") ? OptionalInt.of(Integer.parseInt(number)) : OptionalInt.empty();
    }

    /** The joined lines; without lines the final result. */
    String content() {
        return lines.isEmpty() ? result : String.join(" ", lines);
    }

    /** All lines joined, for a report; without an answer, the kind of ending. */
    String text() {
        return switch (ending) {
            case TIMED_OUT -> lines.isEmpty() ? "no answer" : String.join(" ", lines) + " without a result";
            case LOST -> "connection lost";
            default -> Stream.concat(lines.stream(), Stream.of(result)).collect(Collectors.joining(" "));
        };
    }
}
