/**
 * Store and forward of short messages: what a sender hands in is stored, only then acknowledged, and kept until its
 * receiver has taken it or its validity ends. Knows neither links nor disks; both are behind ports.
 *
 * <p>Read first: {@link simgsm.center.smsc.ShortMessageCenter}, then {@link simgsm.center.smsc.MessageStore} and {@link
 * simgsm.center.smsc.DeliveryPort}.
 */
package simgsm.center.smsc;
