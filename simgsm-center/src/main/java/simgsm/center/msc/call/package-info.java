/**
 * Call control on the network side, and the switching of speech. Read first: {@link simgsm.center.msc.call.CallSwitch}, then
 * {@code NetworkCall}, {@code CallLeg} and {@link simgsm.center.msc.call.NetworkCallTable}.
 */
package simgsm.center.msc.call;
