/**
 * Short messages over the air interface, network side (TS 24.011). Read first: {@link
 * simgsm.center.msc.sms.OriginatingTransferTable} and {@link simgsm.center.msc.sms.TerminatingTransferTable}.
 */
package simgsm.center.msc.sms;
