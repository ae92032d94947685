package simgsm.center.smsc;

import java.time.Instant;

/**
 * One attempt to give a message to its receiver.
 *
 * @param at when it ended
 */
public record Attempt(Instant at, DeliveryOutcome outcome) {}
