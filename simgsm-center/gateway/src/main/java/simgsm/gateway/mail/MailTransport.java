package simgsm.gateway.mail;

import simgsm.gateway.esme.TcpProtocol;

/** The way to the mail server, and what the console hears; given by the program. */
public interface MailTransport {
    /** Opens one connection to the mail server; a failure is {@link TcpProtocol#lost}. */
    void connect(TcpProtocol client);

    /** The mail server has taken a message. @param id the left part of its Message-ID */
    void mailed(String id, String to);

    /** The mail server has not taken a message. */
    void failed(String id, String to, String text);

    /** A mail was refused for good. @param cause the reply's code */
    void refused(String from, int cause, String text);
}
