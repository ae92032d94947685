/**
 * When a call moves to another cell: decisions on measurement reports, without any knowledge of channels. Read {@link
 * simgsm.center.bsc.handover.HandoverDecision} first.
 */
package simgsm.center.bsc.handover;
