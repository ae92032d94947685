package vericommand;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Limits the replies to messages without a valid order, which otherwise would not end between two programs that
 * answer each other. Senders and times are passed in.
 */
final class AnswerLimit {
    /** Answers to one sender within {@link #MINUTE_NANOS}; then it gets none for as long. */
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
        /** Times of the answers within the last minute. */
        final Deque<Long> answers = new ArrayDeque<>();

        boolean isSilenced;
        /** Time of the last answer, or of the start of the silence. */
        long newestNanos;
    }

    /** Senders of the last minute, ordered by {@link Sender#newestNanos}. */
    private final Map<String, Sender> senders = new LinkedHashMap<>();

    /** Rules on a message without a valid order. */
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
