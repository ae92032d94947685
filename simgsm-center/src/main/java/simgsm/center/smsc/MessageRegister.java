package simgsm.center.smsc;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import simgsm.air.Msisdn;
import simgsm.timer.BoundedMap;

/** The waiting messages, and the last ended ones, by id; without reports. */
public final class MessageRegister {
    static final int MAX_ENDED_HISTORIES = 1_000;

    /** Ids increase in the order of acceptance. */
    private final Map<Long, QueueEntry> waiting;

    /** The latest message of each source and receiver of an application; {@link QueueEntry#older} has the others. */
    private final Map<SentKey, QueueEntry> latest = new HashMap<>();

    private final Map<Long, MessageHistory> ended = new BoundedMap<>(MAX_ENDED_HISTORIES);

    private record SentKey(String systemId, String source, Msisdn to) {
        static SentKey of(ShortMessage message) {
            EsmeOrigin origin = message.esme().orElseThrow();
            return new SentKey(origin.systemId(), origin.source().value(), message.to());
        }
    }

    /** @param waiting an empty map that keeps the order of insertion */
    MessageRegister(Map<Long, QueueEntry> waiting) {
        this.waiting = waiting;
    }

    void add(QueueEntry entry) {
        ShortMessage message = entry.envelope.message();
        waiting.put(message.id(), entry);
        if (message.esme().isPresent()) {
            entry.older = latest.put(SentKey.of(message), entry);
            if (entry.older != null) {
                entry.older.newer = entry;
            }
        }
    }

    private void unlink(QueueEntry entry, SentKey key) {
        if (entry.older != null) {
            entry.older.newer = entry.newer;
        }
        if (entry.newer != null) {
            entry.newer.older = entry.older;
        } else if (entry.older != null) {
            latest.put(key, entry.older);
        } else {
            latest.remove(key);
        }
    }

    /**
     * The waiting messages of an application from a source to a receiver, latest first. Messages may end during the
     * iteration.
     */
    public Stream<ShortMessage> sent(String systemId, String source, Msisdn to) {
        return Stream.iterate(latest.get(new SentKey(systemId, source, to)), Objects::nonNull, entry -> entry.older)
                .map(entry -> entry.envelope.message());
    }

    void ended(QueueEntry entry, MessageState state, Instant now) {
        ShortMessage message = entry.envelope.message();
        waiting.remove(message.id());
        message.esme().ifPresent(origin -> unlink(entry, SentKey.of(message)));
        ended.put(
                message.id(),
                new MessageHistory(
                        message,
                        state,
                        WaitReason.ENDED,
                        entry.attempts,
                        entry.attemptCount,
                        Optional.empty(),
                        Optional.of(now)));
    }

    /** The entry of a waiting message; null if there is none. */
    QueueEntry entry(long id) {
        return waiting.get(id);
    }

    /** The waiting messages, in the order of acceptance. */
    public List<ShortMessage> waiting() {
        return waiting(Integer.MAX_VALUE);
    }

    /** The first waiting messages, at most {@code limit}. */
    public List<ShortMessage> waiting(int limit) {
        return entries(limit).map(entry -> entry.envelope.message()).toList();
    }

    /** The histories of the first waiting messages, at most {@code limit}. */
    public List<MessageHistory> waitingHistories(int limit) {
        return entries(limit).map(entry -> entry.queue.history(entry)).toList();
    }

    Stream<QueueEntry> entries(int limit) {
        return waiting.values().stream().limit(limit);
    }

    /** The histories of the last ended messages, newest first, at most {@code limit}. */
    public List<MessageHistory> endedHistories(int limit) {
        List<MessageHistory> newest = new ArrayList<>(ended.values());
        Collections.reverse(newest);
        return newest.subList(0, Math.min(limit, newest.size()));
    }

    /** The message with this id, if it waits. */
    public Optional<ShortMessage> waitingMessage(long id) {
        return Optional.ofNullable(waiting.get(id)).map(entry -> entry.envelope.message());
    }

    /** A message's history; empty if the id is unknown, or {@link #MAX_ENDED_HISTORIES} have ended since. */
    public Optional<MessageHistory> history(long id) {
        QueueEntry entry = waiting.get(id);
        return Optional.ofNullable(entry == null ? ended.get(id) : entry.queue.history(entry));
    }
}
