package simgsm.center.journal;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.StoreEntry;
import simgsm.center.smsc.StoredState;

/**
 * The sum of all entries so far, as needed by a restart. Messages are shared with the short message centre, so a
 * waiting one costs only a map entry here.
 */
final class JournalState {
    /** Time during which repetitions are recognised, among the latest {@code maxRecent} messages. */
    private static final Duration RECENT = Duration.ofHours(1);

    /** Approximate octets of an accepted message on disk besides its SUBMIT. */
    private static final int MESSAGE_OCTETS = 100;

    private final SortedMap<Long, ShortMessage> waiting = new TreeMap<>();
    /** Ended messages with a pending report. */
    private final SortedMap<Long, StoredState.Unreported> unreported = new TreeMap<>();

    private final Deque<ShortMessage> recent = new ArrayDeque<>();
    private final Map<Msisdn, StoreEntry.Known> known = new LinkedHashMap<>();
    private final int maxRecent;
    private long lastId;
    private long octets;

    JournalState(int maxRecent) {
        this.maxRecent = maxRecent;
    }

    void apply(StoreEntry entry) {
        if (entry instanceof StoreEntry.Accepted accepted) {
            accept(accepted.message());
        } else if (entry instanceof StoreEntry.Ended ended) {
            end(ended);
        } else if (entry instanceof StoreEntry.Reported reported) {
            forget(reported.id());
        } else if (entry instanceof StoreEntry.Known subscriber) {
            known.put(subscriber.number(), subscriber);
        } else if (entry instanceof StoreEntry.Numbered numbered) {
            lastId = Math.max(lastId, numbered.lastId());
        }
    }

    private void accept(ShortMessage message) {
        lastId = Math.max(lastId, message.id());
        forget(message.id());
        waiting.put(message.id(), message);
        octets += octetsOf(message);
        recent.addLast(message);
        while (recent.size() > maxRecent
                || recent.peekFirst().acceptedAt().plus(RECENT).isBefore(message.acceptedAt())) {
            recent.removeFirst();
        }
    }

    private void end(StoreEntry.Ended ended) {
        ShortMessage message = forget(ended.id());
        if (message != null && ended.reportFollows()) {
            unreported.put(ended.id(), new StoredState.Unreported(message, ended));
            octets += octetsOf(message);
        }
    }

    /**
     * Removes a message in any state.
     *
     * @return null if it is unknown
     */
    private ShortMessage forget(long id) {
        StoredState.Unreported hasEnded = unreported.remove(id);
        ShortMessage gone = hasEnded == null ? waiting.remove(id) : hasEnded.message();
        octets -= gone == null ? 0 : octetsOf(gone);
        return gone;
    }

    private static int octetsOf(ShortMessage message) {
        return MESSAGE_OCTETS + message.submit().length();
    }

    /** Approximate octets of {@link #image} on disk. */
    long octets() {
        return octets + (long) (recent.size() + known.size()) * 2 * MESSAGE_OCTETS;
    }

    /** Number of messages that wait or have a pending report. */
    int messages() {
        return waiting.size() + unreported.size();
    }

    /** The shortest sequence of entries with the current sum, generated while it is read. */
    Iterator<StoreEntry> image() {
        List<ShortMessage> endedLately = recent.stream()
                .filter(message -> !waiting.containsKey(message.id()) && !unreported.containsKey(message.id()))
                .toList();
        List<StoreEntry> few = new ArrayList<>(known.values());
        few.add(new StoreEntry.Numbered(lastId));
        Stream<StoreEntry> ended = endedLately.stream().flatMap(JournalState::accepted);
        Stream<StoreEntry> due = List.copyOf(unreported.values()).stream()
                .flatMap(each -> Stream.of(new StoreEntry.Accepted(each.message()), each.ended()));
        Stream<StoreEntry> open = List.copyOf(waiting.values()).stream().map(StoreEntry.Accepted::new);
        return Stream.concat(Stream.concat(few.stream(), ended), Stream.concat(due, open))
                .iterator();
    }

    private static Stream<StoreEntry> accepted(ShortMessage message) {
        return Stream.of(
                new StoreEntry.Accepted(message),
                new StoreEntry.Ended(message.id(), MessageState.DELIVERED, message.acceptedAt(), false));
    }

    StoredState stored() {
        return new StoredState(
                lastId,
                List.copyOf(waiting.values()),
                List.copyOf(unreported.values()),
                List.copyOf(recent),
                List.copyOf(known.values()));
    }
}
