package simgsm.center.smsc;

import java.time.Instant;
import simgsm.event.EventLine;

/**
 * An attempt to deliver a message.
 *
 * @param at its end
 */
@EventLine("attempt at= outcome=")
public record DeliveryAttempt(Instant at, DeliveryOutcome outcome) {}
