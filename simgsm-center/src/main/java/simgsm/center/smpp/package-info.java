/**
 * The centre's side of SMPP 3.4 for applications (ESMEs), without sockets and clock. Clause numbers are those of SMPP v3.4
 * issue 1.2.
 *
 * <p>Read first: {@link simgsm.center.smpp.SmppSessionTable}; then {@link simgsm.center.smpp.SmppServer} and {@link
 * simgsm.center.smpp.EsmeSession}. {@code MessageRequests} fulfils what applications request, {@code EsmeRoutes} finds the
 * session that gets a message, {@code CircuitBreaker} decides whether a session gets any, {@code MessageContent} converts
 * user data.
 */
package simgsm.center.smpp;
