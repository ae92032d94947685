/**
 * Supplementary services on the network side (TS 24.080, TS 24.090): USSD dialogues with mobiles and the services behind their
 * codes, and operations on call forwarding and call waiting; all other services are refused.
 *
 * <p>Read first: {@link simgsm.center.msc.ss.UssdDialogues}, then {@link simgsm.center.msc.ss.UssdServices}.
 */
package simgsm.center.msc.ss;
