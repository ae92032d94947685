/**
 * Messages in words, for the windows and traces: name, fields and octets of a layer-3 or RSL message, and the fields of a
 * short message. Read {@link simgsm.trace.MessageText}.
 */
package simgsm.trace;
