package simgsm.center.ui;

import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import simgsm.center.msc.ExchangeSnapshot.MessageRow;
import simgsm.center.smsc.DeliveryAttempt;
import simgsm.center.smsc.MessageHistory;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.WaitReason;
import simgsm.console.TextBundle;
import simgsm.draw.Ink;
import simgsm.draw.StatusMark;

/** The history of a message, in the user's language and time zone. */
final class HistoryWords {
    private static final ZoneId ZONE = ZoneId.systemDefault();
    private static final DateTimeFormatter CLOCK =
            DateTimeFormatter.ofPattern("HH:mm:ss").withZone(ZONE);
    private static final DateTimeFormatter DAY =
            DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss").withZone(ZONE);

    private HistoryWords() {}

    /** The state of a message, or its outcome after its end. */
    static StateWord state(MessageRow row, TextBundle texts) {
        MessageHistory history = row.history();
        if (history.waitReason() == WaitReason.ENDED) {
            String word = texts.of("window.message." + lower(history.state()));
            return history.state() == MessageState.DELIVERED
                    ? new StateWord(StatusMark.DISC, Ink.GOOD, word)
                    : new StateWord(StatusMark.BURST, Ink.DANGER, word);
        }
        String word = texts.of("window.standing." + lower(history.waitReason()));
        return switch (history.waitReason()) {
            case UNDER_WAY -> new StateWord(StatusMark.ARROW, Ink.GOOD, word);
            case BEHIND_OTHERS -> new StateWord(StatusMark.SQUARE, Ink.QUIET, word);
            case AWAITING_RECEIVER -> new StateWord(StatusMark.RING, Ink.QUIET, word);
            default -> new StateWord(StatusMark.HALF_DISC, Ink.WARNING, word);
        };
    }

    /** The time of the next scheduled attempt; empty if there is none. */
    static String next(MessageRow row) {
        return row.history().nextTry().map(CLOCK::format).orElse("");
    }

    /** One line per event. */
    static List<String> lines(MessageHistory history, TextBundle texts) {
        ShortMessage message = history.message();
        List<String> lines = new ArrayList<>();
        lines.add(texts.of(
                "window.history.title",
                Long.toString(message.id()),
                message.sender().value(),
                message.to().digits()));
        lines.add(texts.of("window.history.accepted", DAY.format(message.acceptedAt())));
        int forgotten = history.attemptCount() - history.attempts().size();
        if (forgotten > 0) {
            lines.add(texts.of("window.history.forgotten", forgotten));
        }
        for (DeliveryAttempt attempt : history.attempts()) {
            lines.add(texts.of(
                    "window.history.tried",
                    clock(attempt.at(), message.acceptedAt()),
                    texts.of("window.outcome." + lower(attempt.outcome()))));
        }
        history.nextTry().ifPresent(at -> lines.add(texts.of("window.history.next", clock(at, message.acceptedAt()))));
        if (history.endedAt().isPresent()) {
            lines.add(texts.of(
                    "window.history.ended",
                    clock(history.endedAt().get(), message.acceptedAt()),
                    texts.of("window.message." + lower(history.state()))));
        } else {
            lines.add(texts.of("window.standing." + lower(history.waitReason()) + ".why"));
            lines.add(texts.of("window.history.expires", DAY.format(message.expiresAt())));
        }
        return lines;
    }

    /** The time, with the date if it differs from that of the first event. */
    private static String clock(Instant at, Instant first) {
        boolean isSameDay = LocalDate.ofInstant(at, ZONE).equals(LocalDate.ofInstant(first, ZONE));
        return (isSameDay ? CLOCK : DAY).format(at);
    }

    private static String lower(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT);
    }
}
