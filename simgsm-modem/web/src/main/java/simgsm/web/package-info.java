/**
 * A read-only web server on the JDK's HTTP server, which all programs share. Read first {@link simgsm.web.WebPort}.
 */
package simgsm.web;
