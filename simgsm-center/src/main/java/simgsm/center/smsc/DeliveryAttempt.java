package simgsm.center.smsc;

import java.time.Instant;

/**
 * One attempt to deliver a message.
 *
 * @param at when it ended
 */
public record DeliveryAttempt(Instant at, DeliveryOutcome outcome) {}
