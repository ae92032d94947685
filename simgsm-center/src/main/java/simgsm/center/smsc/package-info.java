/**
 * The short message centre: stores each submitted message, then acknowledges it, and keeps it until it is delivered or
 * its validity ends. Links, applications and disks are accessed through {@link simgsm.center.smsc.DeliveryPort} and
 * {@link simgsm.center.smsc.MessageStore}.
 *
 * <p>Read first: {@link simgsm.center.smsc.ShortMessageCenter}.
 */
package simgsm.center.smsc;
