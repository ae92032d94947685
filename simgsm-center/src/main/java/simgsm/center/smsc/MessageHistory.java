package simgsm.center.smsc;

import java.time.Instant;
import java.util.List;
import java.util.Optional;

/**
 * What has happened to a message so far, and what is to happen next. A centre that starts again knows when the message was
 * accepted, and not how often it was tried.
 *
 * @param attempts the latest, oldest first
 * @param attemptCount of all attempts
 * @param nextTry when the schedule says so
 * @param endedAt empty while it waits
 */
public record MessageHistory(
        ShortMessage message,
        MessageState state,
        Standing standing,
        List<Attempt> attempts,
        int attemptCount,
        Optional<Instant> nextTry,
        Optional<Instant> endedAt) {}
