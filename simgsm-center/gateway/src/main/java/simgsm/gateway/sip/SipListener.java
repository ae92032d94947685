package simgsm.gateway.sip;

import simgsm.air.Msisdn;

/** Receives what users of SIP phones do. */
public interface SipListener {
    /** A phone has registered. @param from its address */
    void joined(Msisdn number, String from);

    /** A phone has gone: by itself, at the end of its registration, or refused by the network. */
    void left(Msisdn number);

    /** A request was refused. @param status of the response */
    void refused(String from, int status, String text);
}
