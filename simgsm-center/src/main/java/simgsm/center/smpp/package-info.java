/**
 * SMPP 3.4 for applications (ESMEs), without sockets and clock. Clause numbers are those of SMPP v3.4 issue 1.2.
 *
 * <p>Read first: {@link simgsm.center.smpp.SmppPdu} and {@link simgsm.center.smpp.SmppCodec}; {@link
 * simgsm.center.smpp.SmppSessionTable}; then {@link simgsm.center.smpp.SmppServer} and {@link
 * simgsm.center.smpp.EsmeSession}. {@code EsmeRoutes} finds the application that serves a number, {@code MessageContent}
 * converts user data.
 */
package simgsm.center.smpp;
