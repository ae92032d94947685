package simgsm.center.smsc;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import simgsm.event.EventLine;

/**
 * The attempts at a message so far and the next one. After a restart the centre knows the message's acceptance, but not
 * its earlier attempts.
 *
 * <p>As a line: answer to {@code message ID}; the attempts follow.
 *
 * @param attempts the latest, oldest first, at most {@link #MAX_ATTEMPTS}
 * @param attemptCount of all attempts
 * @param nextTry by the schedule; empty if no schedule runs
 * @param endedAt empty while it waits
 */
@EventLine("message id=message.id from=message.from to=message.to state= standing=waitReason"
        + " accepted=message.acceptedAt expires=message.expiresAt attempts=attemptCount [next=nextTry] [ended=endedAt]")
public record MessageHistory(
        ShortMessage message,
        MessageState state,
        WaitReason waitReason,
        List<DeliveryAttempt> attempts,
        int attemptCount,
        Optional<Instant> nextTry,
        Optional<Instant> endedAt) {
    /** A message with the longest validity (63 weeks) and the longest pause (12 h) is tried 900 times. */
    static final int MAX_ATTEMPTS = 20;
}
