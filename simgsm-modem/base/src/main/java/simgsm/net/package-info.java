/**
 * Sockets with a selector: one thread serves listening ports, connections and outgoing connections, within limits,
 * and drives their core. Read {@link simgsm.net.SelectorLoop} first, then {@link simgsm.net.Connection}.
 */
package simgsm.net;
