/**
 * A look at the centre from outside, read-only, by HTTP: metrics for Prometheus and lists as JSON. Read first {@link
 * simgsm.center.web.CenterPages}.
 */
package simgsm.center.web;
