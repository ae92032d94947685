package simgsm.center.journal;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
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
    /** Repetitions are recognised for this time, and among the latest {@link #MAX_RECENT} messages. */
    private static final Duration RECENT = Duration.ofHours(1);

    static final int MAX_RECENT = 20_000;
    /** Approximate octets of an accepted message on disk besides its SUBMIT. */
    private static final int MESSAGE_OCTETS = 100;

    private record Kept(ShortMessage message, StoreEntry.Ended ended) {}

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

    /** The shortest sequence of entries with the same sum. */
    List<StoreEntry> image() {
        List<StoreEntry> image = new ArrayList<>(1 + known.size() + 2 * recent.size() + kept.size());
        image.add(new StoreEntry.Numbered(lastId));
        image.addAll(known.values());
        for (ShortMessage message : recent) {
            if (!kept.containsKey(message.id())) {
                image.add(new StoreEntry.Accepted(message));
                image.add(new StoreEntry.Ended(message.id(), MessageState.DELIVERED, message.acceptedAt(), false));
            }
        }
        for (Kept each : kept.values()) {
            image.add(new StoreEntry.Accepted(each.message()));
            if (each.ended() != null) {
                image.add(each.ended());
            }
        }
        return image;
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
