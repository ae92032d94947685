package simgsm.phone.handset;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import simgsm.air.Coded;
import simgsm.air.Msisdn;
import simgsm.dtmf.DtmfKey;
import simgsm.event.EventForm;
import simgsm.phone.screen.ServiceWords;
import simgsm.phone.screen.Words;
import simgsm.station.context.StationEvent;

/** The log of the newest {@value #CAPACITY} events that concern the user, in words and in order of time. */
public final class HandsetLog {
    static final int CAPACITY = 300;
    /** Keys in one event, three lines in the window; further ones begin the next event. */
    static final int MOST_KEYS = 64;

    /** An event. @param words in the phone's language at the time of display */
    public record Entry(Instant at, Words words) {}

    private final InstantSource wallClock;
    private final UnaryOperator<String> names;
    private final Deque<Entry> entries = new ArrayDeque<>();
    private List<Entry> published = List.of();
    private boolean isPublished = true;

    /** @param names the name of a number */
    HandsetLog(InstantSource wallClock, UnaryOperator<String> names) {
        this.wallClock = wallClock;
        this.names = names;
    }

    /** Oldest first; the same list until the next event. */
    List<Entry> entries() {
        if (!isPublished) {
            published = List.copyOf(entries);
            isPublished = true;
        }
        return published;
    }

    private void add(String key, Object... arguments) {
        if (entries.size() == CAPACITY) {
            entries.removeFirst();
        }
        entries.addLast(new Entry(wallClock.instant(), Words.of(key, arguments)));
        isPublished = false;
    }

    /** The user keys a tone in the call: up to {@value #MOST_KEYS} keys are one event, until another event. */
    void keyed(DtmfKey key) {
        String keys = String.valueOf(key.symbol());
        Entry last = entries.peekLast();
        String before = last != null && last.words().key().equals("log.keys")
                ? (String) last.words().arguments().get(0)
                : "";
        if (!before.isEmpty() && before.length() < MOST_KEYS) {
            entries.removeLast();
            add("log.keys", before + keys);
        } else {
            add("log.keys", keys);
        }
    }

    /** Adds the event if it concerns the user. */
    void accept(StationEvent event) {
        if (event instanceof StationEvent.HoldRefused) {
            add("note.refused");
        } else if (event instanceof HandsetEvent.KeysNotSent refused) {
            add("note.keys_refused", String.valueOf(refused.cause().code()));
        } else if (event instanceof HandsetEvent.ToneHeard heard) {
            String key = String.valueOf(heard.key().symbol());
            heard.meaning()
                    .ifPresentOrElse(
                            meaning -> add("log.tone", key, Words.of(meaning)), () -> add("log.tone.plain", key));
        } else if (event instanceof StationEvent.ShortMessageReceived message) {
            add("log.sms", names.apply(message.from()), message.text());
        } else if (event instanceof StationEvent.ServiceAnswered answer) {
            add("log.service", ServiceWords.title(answer.status()), ServiceWords.state(answer.status()));
        } else if (event instanceof StationEvent.UssdEnded end) {
            ServiceWords.noteOf(end).ifPresent(note -> add("log.ussd-failed", note));
        } else if (!(event instanceof HandsetEvent.KeysSent || event instanceof HandsetEvent.SoundPlayed)) {
            EventForm.of(event)
                    .ifPresent(form -> add(
                            "log." + form.name(),
                            form.values(event, Map.of()).values().stream()
                                    .map(this::argument)
                                    .toArray()));
        }
    }

    /** Numbers are replaced by names; causes become words when displayed. */
    private Object argument(Object value) {
        if (value instanceof Msisdn number) {
            return names.apply(number.toString());
        } else if (value instanceof Coded.Titled) {
            return value;
        }
        return value == Optional.empty() ? Words.of("lcd.unknown") : EventForm.text(value);
    }
}
