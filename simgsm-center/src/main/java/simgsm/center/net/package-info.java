/**
 * The centre's sockets: one thread owns the exchange, passes frames, PDUs and time to it, and writes what it sends. Read
 * {@link simgsm.center.net.CenterLoop} first.
 */
package simgsm.center.net;
