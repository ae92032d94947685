/**
 * Links to terminals: supervision, the radio connection on each, paging, and the signalling timers of the network side.
 * The protocols above implement {@link simgsm.center.msc.link.LinkUser}.
 */
package simgsm.center.msc.link;
