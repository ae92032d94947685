package simgsm.phone.ui;

import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import simgsm.air.Cause;
import simgsm.air.RpCause;
import simgsm.console.TextBundle;
import simgsm.phone.screen.Screen;
import simgsm.phone.screen.Words;

/** The screens' words in one language, with times of one zone. */
final class WordsText {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("HH:mm", Locale.ROOT);
    private static final DateTimeFormatter DAY_AND_TIME = DateTimeFormatter.ofPattern("dd.MM. HH:mm", Locale.ROOT);

    private final TextBundle texts;
    private final ZoneId zone;

    WordsText(TextBundle texts, ZoneId zone) {
        this.texts = texts;
        this.zone = zone;
    }

    String of(Words words) {
        if (words.key().isEmpty()) {
            return String.valueOf(words.arguments().get(0));
        }
        return texts.of(
                words.key(), words.arguments().stream().map(this::argument).toArray());
    }

    private Object argument(Object value) {
        if (value instanceof Words inner) {
            return of(inner);
        }
        if (value instanceof Cause cause) {
            return CauseText.of(texts, cause);
        }
        if (value instanceof RpCause cause) {
            return CauseText.of(texts, cause);
        }
        if (value instanceof Screen.Note note) {
            return CauseText.ofNote(texts, note);
        }
        return value instanceof Instant instant ? dayAndTime(instant) : value;
    }

    String time(Instant instant) {
        return TIME.withZone(zone).format(instant);
    }

    private String dayAndTime(Instant instant) {
        return DAY_AND_TIME.withZone(zone).format(instant);
    }
}
