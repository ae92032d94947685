/**
 * Pages on the JDK's HTTP server and WebSockets, on one port, which all programs share. Read first {@link simgsm.web.WebPort}.
 */
package simgsm.web;
