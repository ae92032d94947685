package simgsm.center.records;

import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simgsm.file.CsvLine;

/**
 * One line of a file of records.
 *
 * @param type call or message
 * @param id of the call since the start of the centre, or of the message
 * @param via system id of the application that sent a message; else empty
 * @param began SETUP received, or message accepted
 * @param answered a call became active
 * @param ended the first clearing message, or the message's end
 * @param lasted since the answer of a call, or the acceptance of a message; 0 for an unanswered call
 * @param result answered or refused; delivered, expired, rejected or deleted
 * @param cause of TS 24.008, for a call
 */
record DetailRecord(
        Type type,
        long id,
        String from,
        String to,
        String via,
        Instant began,
        Optional<Instant> answered,
        Instant ended,
        Duration lasted,
        String result,
        Optional<Integer> cause) {
    /** Subject of a record. */
    enum Type {
        CALL,
        MESSAGE
    }

    static final String HEADER = "type,id,from,to,via,began,answered,ended,seconds,result,cause";

    /** The line, without its end. Times are UTC in milliseconds. */
    String line() {
        return CsvLine.of(List.of(
                type.name().toLowerCase(Locale.ROOT),
                String.valueOf(id),
                from,
                to,
                via,
                time(began),
                answered.map(DetailRecord::time).orElse(""),
                time(ended),
                String.format(Locale.ROOT, "%d.%03d", lasted.toSeconds(), lasted.toMillisPart()),
                result,
                cause.map(String::valueOf).orElse("")));
    }

    private static String time(Instant time) {
        return time.truncatedTo(ChronoUnit.MILLIS).toString();
    }
}
