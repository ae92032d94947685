/**
 * Short messages as mail and back: an application of the SMSC (SMPP 3.4), a client and a server of SMTP (RFC 5321). It
 * keeps nothing: what the other side has not answered yet is not acknowledged. Read first {@link
 * simgsm.gateway.mail.MailGateway}.
 */
package simgsm.gateway.mail;
