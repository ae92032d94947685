/**
 * An application (ESME) of the SMSC: binds, submits, and joins the parts of texts that are delivered to it. A core that is
 * driven by hand: it knows no socket and no clock.
 */
package simgsm.gateway.esme;
