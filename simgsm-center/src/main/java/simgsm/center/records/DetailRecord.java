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
        String result,
        Optional<Integer> cause) {
    /** What a record is about. */
    enum Type {
        CALL,
        MESSAGE
    }

    static final String HEADER = "type,id,from,to,via,began,answered,ended,seconds,result,cause";

    /** The line, without its end. Times are UTC in milliseconds; seconds count from the answer, or else from the beginning. */
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
                seconds(),
                result,
                cause.map(String::valueOf).orElse("")));
    }

    /** Of an unanswered call 0. */
    private String seconds() {
        Instant since = answered.orElse(type == Type.CALL ? ended : began);
        long millis = Math.max(0, Duration.between(since, ended).toMillis());
        return String.format(Locale.ROOT, "%d.%03d", millis / 1000, millis % 1000);
    }

    private static String time(Instant time) {
        return time.truncatedTo(ChronoUnit.MILLIS).toString();
    }
}
