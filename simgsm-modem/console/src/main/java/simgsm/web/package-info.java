/**
 * A read-only web server for HTTP/1.1 (RFC 9112), which all programs share: {@link simgsm.web.WebPort} accepts, a connection
 * reads requests, {@link simgsm.web.WebPages} answers them.
 */
package simgsm.web;
