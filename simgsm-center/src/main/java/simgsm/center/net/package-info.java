/**
 * The centre's sockets: one thread with one selector owns the exchange, gives it frames and time, and writes what it
 * sends. Read {@link simgsm.center.net.CenterLoop} first.
 */
package simgsm.center.net;
