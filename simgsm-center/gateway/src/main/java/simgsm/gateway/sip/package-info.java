/**
 * SIP phones as subscribers (RFC 3261): registrar and user agent as a core without clock, socket and file. Read {@link
 * simgsm.gateway.sip.SipServer} first, then {@link simgsm.gateway.sip.SipCallTable}; the messages are {@link
 * simgsm.gateway.sip.SipMessage}, keys and speech {@link simgsm.gateway.sip.SipSpeech}.
 */
package simgsm.gateway.sip;
