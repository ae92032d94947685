/**
 * Pages on the JDK's HTTP server, and WebSockets, on one port; used by all programs. Read first {@link
 * simgsm.web.WebPort}.
 */
package simgsm.web;
