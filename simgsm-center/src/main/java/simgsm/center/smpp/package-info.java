/**
 * SMPP 3.4 as the short message centre speaks it with applications (ESMEs). No socket, no clock, no file: octets, time and
 * deliveries go in; octets, submissions and closings come out. Clause numbers are those of SMPP v3.4 issue 1.2.
 *
 * <p>Read first: {@link simgsm.center.smpp.SmppPdu} and {@link simgsm.center.smpp.SmppCodec}, the language; {@code
 * SessionState}, what may be said when; then {@link simgsm.center.smpp.SmppServer} and {@link
 * simgsm.center.smpp.EsmeSession}. {@code EsmeRoutes} leads messages to the application that serves their number, {@code
 * MessageContent} translates between user parts and what SMPP calls a short message.
 */
package simgsm.center.smpp;
