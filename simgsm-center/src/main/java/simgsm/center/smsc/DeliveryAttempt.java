package simgsm.center.smsc;

import java.time.Instant;
import simgsm.event.EventLine;

/**
 * An attempt to deliver a message.
 *
 * @param at when it ended
 */
@EventLine("attempt at= outcome=")
public record DeliveryAttempt(Instant at, DeliveryOutcome outcome) {}
