package simgsm.center.smsc;

import java.time.Instant;
import java.util.List;
import java.util.stream.Stream;
import simgsm.timer.Timer;

/** An envelope in a {@link ReceiverQueue}, which alone modifies it. */
final class QueueEntry {
    /**
     * The order of postponed entries.
     *
     * @param availability number of times that the receiver had become available; entries with a lower number are due
     * at once
     */
    record Due(long availability, long nanos, long place) implements Comparable<Due> {
        @Override
        public int compareTo(Due other) {
            int byAvailability = Long.compare(availability, other.availability);
            int byTime = byAvailability == 0 ? Long.compare(nanos, other.nanos) : byAvailability;
            return byTime == 0 ? Long.compare(place, other.place) : byTime;
        }
    }

    final ReceiverQueue queue;
    Envelope envelope;
    /** Position in the order of acceptance. */
    final long place;

    List<DeliveryAttempt> attempts = List.of();
    int attemptCount;
    /** Failed attempts that count for {@link RetrySchedule}: postponed or unanswered, and busy. */
    int failures;

    int refusals;
    /** Runs until the scheduled time of delivery, then until the validity ends. */
    Timer timer;

    boolean isScheduled;
    /** An attempt is under way, or the message is being replaced. */
    boolean isInFlight;
    /** Time of the next attempt; null unless it is postponed. */
    Due due;
    /** The preceding entries from the same source of an application to the same receiver, as a list. */
    QueueEntry older;

    QueueEntry newer;
    /** Final state if the current attempt fails; null if another attempt follows. */
    MessageState stateOnFailure;

    QueueEntry(ReceiverQueue queue, Envelope envelope, long place) {
        this.queue = queue;
        this.envelope = envelope;
        this.place = place;
    }

    /** @return growth of the stored attempts */
    int attempted(Instant at, DeliveryOutcome outcome) {
        int before = attempts.size();
        attemptCount++;
        attempts = Stream.concat(
                        attempts.stream().skip(attempts.size() / MessageHistory.MAX_ATTEMPTS),
                        Stream.of(new DeliveryAttempt(at, outcome)))
                .toList();
        return attempts.size() - before;
    }
}
