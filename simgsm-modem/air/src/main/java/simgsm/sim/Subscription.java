package simgsm.sim;

/**
 * A subscriber as an operator enters him.
 *
 * @param isBarred whether the operator lets nobody register with this card; on a card itself without meaning
 */
public record Subscription(SimCard card, boolean isBarred) {}
