package simgsm.center.journal;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.center.smsc.MessageState;
import simgsm.center.smsc.ShortMessage;
import simgsm.center.smsc.StoreEntry;
import simgsm.center.smsc.StoredState;

/**
 * The sum of all entries so far: what a restart needs. Messages are shared with the short message centre, so a waiting one
 * costs only a map entry here.
 */
final class JournalState {
    /** Repetitions are recognised for this time, and among the latest {@code maxRecent} messages. */
    private static final Duration RECENT = Duration.ofHours(1);

    /** Approximate octets of an accepted message on disk besides its SUBMIT. */
    private static final int MESSAGE_OCTETS = 100;

    private record Kept(ShortMessage message, StoreEntry.Ended ended) {
        Stream<StoreEntry> entries() {
            StoreEntry accepted = new StoreEntry.Accepted(message);
            return ended == null ? Stream.of(accepted) : Stream.of(accepted, ended);
        }
    }

    private final Map<Long, Kept> kept = new TreeMap<>();
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
        Kept replaced = kept.put(message.id(), new Kept(message, null));
        octets += octetsOf(message) - (replaced == null ? 0 : octetsOf(replaced.message()));
        recent.addLast(message);
        while (recent.size() > maxRecent
                || recent.peekFirst().acceptedAt().plus(RECENT).isBefore(message.acceptedAt())) {
            recent.removeFirst();
        }
    }

    private void end(StoreEntry.Ended ended) {
        Kept ending = kept.get(ended.id());
        if (ending == null || !ended.reportFollows()) {
            forget(ended.id());
        } else {
            kept.put(ended.id(), new Kept(ending.message(), ended));
        }
    }

    private void forget(long id) {
        Kept gone = kept.remove(id);
        octets -= gone == null ? 0 : octetsOf(gone.message());
    }

    private static int octetsOf(ShortMessage message) {
        return MESSAGE_OCTETS + message.submit().length();
    }

    /** Approximate octets of {@link #image} on disk. */
    long octets() {
        return octets + (long) (recent.size() + known.size()) * 2 * MESSAGE_OCTETS;
    }

    /** Messages that wait or whose report is due. */
    int messages() {
        return kept.size();
    }

    /** The shortest sequence of entries with the same sum, as it is now; made one by one while it is read. */
    Iterator<StoreEntry> image() {
        List<ShortMessage> endedLately = recent.stream()
                .filter(message -> !kept.containsKey(message.id()))
                .toList();
        List<StoreEntry> few = new ArrayList<>(known.values());
        few.add(new StoreEntry.Numbered(lastId));
        Stream<StoreEntry> ended = endedLately.stream().flatMap(JournalState::accepted);
        Stream<StoreEntry> others = List.copyOf(kept.values()).stream().flatMap(Kept::entries);
        return Stream.concat(few.stream(), Stream.concat(ended, others)).iterator();
    }

    private static Stream<StoreEntry> accepted(ShortMessage message) {
        return Stream.of(
                new StoreEntry.Accepted(message),
                new StoreEntry.Ended(message.id(), MessageState.DELIVERED, message.acceptedAt(), false));
    }

    StoredState stored() {
        List<ShortMessage> waiting = new ArrayList<>();
        List<StoredState.Unreported> unreported = new ArrayList<>();
        for (Kept each : kept.values()) {
            if (each.ended() == null) {
                waiting.add(each.message());
            } else {
                unreported.add(new StoredState.Unreported(each.message(), each.ended()));
            }
        }
        return new StoredState(lastId, waiting, unreported, List.copyOf(recent), List.copyOf(known.values()));
    }
}
