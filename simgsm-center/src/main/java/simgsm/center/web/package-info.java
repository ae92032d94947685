/**
 * Read-only access to the centre by HTTP: metrics for Prometheus and lists as JSON. Read first {@link
 * simgsm.center.web.CenterPages}.
 */
package simgsm.center.web;
