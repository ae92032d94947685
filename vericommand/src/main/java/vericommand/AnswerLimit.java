package vericommand;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Limits the replies to messages without a valid order: two programs that answer each other's messages would never end. A
 * core: senders and time in.
 */
final class AnswerLimit {
    /** Answers to one sender within {@link #MINUTE_NANOS}; after them the sender is not answered for as long. */
    static final int MAX_ANSWERS = 300;

    static final long MINUTE_NANOS = 60_000_000_000L;

    /** Treatment of a message. */
    enum Ruling {
        ANSWER,
        /** The silence begins with this message. */
        BE_SILENT,
        STAY_SILENT
    }

    private static final class Sender {
        /** The times of the answers within the last minute. */
        final Deque<Long> answers = new ArrayDeque<>();

        boolean isSilenced;
        /** Of the last answer, or of the begin of the silence. */
        long newestNanos;
    }

    /** The senders of the last minute, by the time of their last answer or of the begin of their silence. */
    private final Map<String, Sender> senders = new LinkedHashMap<>();

    /** A message without a valid order has come. */
    Ruling decide(String from, long nowNanos) {
        forgetOld(nowNanos);
        Sender sender = senders.computeIfAbsent(from, unknown -> new Sender());
        if (sender.isSilenced) {
            return Ruling.STAY_SILENT;
        }
        while (!sender.answers.isEmpty() && isOld(sender.answers.getFirst(), nowNanos)) {
            sender.answers.removeFirst();
        }
        sender.isSilenced = sender.answers.size() == MAX_ANSWERS;
        sender.newestNanos = nowNanos;
        if (!sender.isSilenced) {
            sender.answers.addLast(nowNanos);
        }
        senders.remove(from);
        senders.put(from, sender);
        return sender.isSilenced ? Ruling.BE_SILENT : Ruling.ANSWER;
    }

    private void forgetOld(long nowNanos) {
        Iterator<Sender> oldestFirst = senders.values().iterator();
        while (oldestFirst.hasNext() && isOld(oldestFirst.next().newestNanos, nowNanos)) {
            oldestFirst.remove();
        }
    }

    private static boolean isOld(long timeNanos, long nowNanos) {
        return nowNanos - timeNanos >= MINUTE_NANOS;
    }
}
