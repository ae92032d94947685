package simgsm.sms;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Joins the parts of messages, in any order and with repetitions. Unfinished messages are dropped after 24 h, and the
 * oldest beyond {@link #MAX_MESSAGES}.
 */
public final class Reassembler {
    /** Unfinished messages of all senders. */
    public static final int MAX_MESSAGES = 64;

    static final long EXPIRY_NANOS = 24L * 60 * 60 * 1_000_000_000;

    /** A reference is unique for one sender only, and messages with different numbers of parts are different. */
    private record Key(SmsAddress sender, int reference, int total) {}

    private static final class Unfinished {
        private final UserData[] parts;
        private final long sinceNanos;
        private int missing;

        Unfinished(int total, long sinceNanos) {
            this.parts = new UserData[total];
            this.missing = total;
            this.sinceNanos = sinceNanos;
        }

        void put(int part, UserData data) {
            if (parts[part - 1] == null) {
                parts[part - 1] = data;
                missing--;
            }
        }

        boolean contradicts(int part, UserData data) {
            return parts[part - 1] != null && !parts[part - 1].equals(data);
        }

        String text() {
            StringBuilder text = new StringBuilder();
            for (UserData part : parts) {
                text.append(part.shownText());
            }
            return text.toString();
        }
    }

    private final Map<Key, Unfinished> unfinished = new LinkedHashMap<>();

    public Reassembler() {}

    /** The whole text if this part was the last one missing; made of {@link UserData#shownText}. */
    public Optional<String> accept(SmsAddress sender, UserData data, long nowNanos) {
        Optional<Concatenation> place = data.concatenation();
        if (place.isEmpty() || place.get().total() == 1) {
            return Optional.of(data.shownText());
        }
        dropExpired(nowNanos);
        Key key = new Key(sender, place.get().reference(), place.get().total());
        Unfinished message = unfinished.get(key);
        if (message == null || message.contradicts(place.get().part(), data)) {
            message = begin(key, nowNanos);
        }
        message.put(place.get().part(), data);
        if (message.missing > 0) {
            return Optional.empty();
        }
        unfinished.remove(key);
        return Optional.of(message.text());
    }

    /** Replaces an unfinished message with the same reference. */
    private Unfinished begin(Key key, long nowNanos) {
        unfinished.remove(key);
        if (unfinished.size() == MAX_MESSAGES) {
            Iterator<Key> oldest = unfinished.keySet().iterator();
            oldest.next();
            oldest.remove();
        }
        Unfinished message = new Unfinished(key.total(), nowNanos);
        unfinished.put(key, message);
        return message;
    }

    private void dropExpired(long nowNanos) {
        unfinished.values().removeIf(message -> nowNanos - message.sinceNanos > EXPIRY_NANOS);
    }
}
