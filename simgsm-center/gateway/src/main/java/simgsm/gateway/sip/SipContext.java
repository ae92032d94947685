package simgsm.gateway.sip;

import java.util.random.RandomGenerator;
import simgsm.timer.Timers;

/** The settings and services that calls and users share. */
record SipContext(Timers timers, RandomGenerator random, SipTransport transport, SipTransactions transactions) {
    /** A URI of this side. */
    String uri(String user, SipPeer peer) {
        return "sip:" + user + "@" + SipPeer.inUri(transport.hostTowards(peer)) + ":" + transport.port();
    }

    /** A request to a phone with the fields that each needs; Route, Contact and a body may follow. */
    SipMessage request(String method, String uri, SipPeer peer, String from, String to, String callId, long cseq) {
        return SipMessage.request(method, uri)
                .with("Via", transactions.via(peer))
                .with("Max-Forwards", "70")
                .with("From", from)
                .with("To", to)
                .with("Call-ID", callId)
                .with("CSeq", cseq + " " + method);
    }
}
