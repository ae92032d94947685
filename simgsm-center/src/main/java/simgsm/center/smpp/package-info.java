/**
 * The centre's side of SMPP 3.4 for applications (ESMEs), without sockets and clock. Clause numbers are those of SMPP
 * v3.4 issue 1.2.
 *
 * <p>Read first: {@link simgsm.center.smpp.SmppSessionTable}; then {@link simgsm.center.smpp.SmppServer} and {@link
 * simgsm.center.smpp.EsmeSession}. {@code MessageRequests} fulfils requests of applications, {@code EsmeRoutes} finds
 * the session for a message, {@code CircuitBreaker} pauses failing sessions, {@code MessageContent} converts user data.
 */
package simgsm.center.smpp;
