/**
 * The gateway: each browser is a mobile station of the network, each SIP phone another, and mail an application of its SMSC. Read first {@link simgsm.gateway.WebUsers}, then {@link
 * simgsm.gateway.WebUser}.
 */
package simgsm.gateway;
