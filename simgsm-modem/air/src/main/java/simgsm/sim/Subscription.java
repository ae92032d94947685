package simgsm.sim;

/**
 * A subscriber in the network's list.
 *
 * @param isBarred true if the network refuses registrations with this card; ignored in a terminal
 */
public record Subscription(SimCard card, boolean isBarred) {}
