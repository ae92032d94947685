/**
 * The switching centre as one deterministic core: links and their radio connections, registration, calls, the short
 * message dialogues, cell broadcast. Arrows point down: msc, then smsc and subscriber, then timer.
 *
 * <p>Read first: {@link simgsm.center.msc.Exchange}; then for a call {@code CallSwitch}, {@code Call}, {@code CallLeg}
 * and their table {@code CallTransitions}; for a registration {@code Mobility} and {@code Registration}; for a short
 * message {@code OriginatingTransfer} and {@code TerminatingTransfer}.
 */
package simgsm.center.msc;
