/**
 * The subscriber's card and its secrets: Milenage, what a card holds, and the files that list cards. Read
 * {@link simgsm.sim.SimCard} first, then {@link simgsm.sim.SimFile}.
 */
package simgsm.sim;
