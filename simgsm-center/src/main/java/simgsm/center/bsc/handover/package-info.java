/**
 * Handover: decisions on measurement reports, independent of channels. Read {@link
 * simgsm.center.bsc.handover.HandoverDecision} first.
 */
package simgsm.center.bsc.handover;
