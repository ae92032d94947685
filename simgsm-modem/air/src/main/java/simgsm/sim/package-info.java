/**
 * The subscriber's card: MILENAGE, the data of a card, and files that list cards. Read {@link simgsm.sim.SimCard} first,
 * then {@link simgsm.sim.SimFile}.
 */
package simgsm.sim;
