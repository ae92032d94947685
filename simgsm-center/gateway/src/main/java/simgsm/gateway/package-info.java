/**
 * The gateway: each browser is a mobile station of the network. Read first {@link simgsm.gateway.WebUsers}, then {@link
 * simgsm.gateway.WebUser}.
 */
package simgsm.gateway;
