package simgsm.center.msc.link;

import java.util.concurrent.TimeUnit;

/** Signalling timers of the network side, with their clause; our own timers have no number. */
public enum NetworkTimer {
    // Call control: TS 24.008, table 11.4.

    /** The called mobile alerts without an answer; at least 3 minutes. */
    T301(180),
    /** SETUP is not answered. */
    T303(30),
    /** DISCONNECT is not answered. */
    T305(30),
    /** DISCONNECT with a tone is not answered; the network's choice, at most 30 s. */
    T306(30),
    /** RELEASE is not answered; runs twice. */
    T308(30),
    /** CALL CONFIRMED is not followed by ALERTING or CONNECT. */
    T310(30),
    /** CONNECT is not acknowledged. */
    T313(30),

    // Mobility management: TS 24.008, table 11.2.

    /** LOCATION UPDATING ACCEPT with a TMSI is not answered. */
    T3250(12),
    /** AUTHENTICATION REQUEST is not answered. */
    T3260(12),
    /** IDENTITY REQUEST is not answered. */
    T3270(12),

    // Radio resource: TS 44.018, 11.1.2.

    /** The mobile has not left the channel after CHANNEL RELEASE. */
    T3109(5),
    /** PAGING REQUEST is not answered; the network's choice. */
    T3113(3),

    // Short messages: TS 24.011, 10.

    /** TC1*: CP-DATA is not acknowledged. */
    TC1(10),
    /** RP-DATA is not answered; 35 to 45 s. */
    TR1N(40),

    // Our own.

    /** A mobile's user does not answer a USSD question. */
    USSD_REPLY(60),
    /** The mobile does not begin the transaction that CM SERVICE ACCEPT allows. */
    SERVICE(10),
    /** Length of the notice that answers an emergency call. */
    NOTICE(5),
    /** A called mobile does not finish clearing its last call. */
    HELD_CALL(5),
    /** A peer, such as a port scanner, neither identifies itself nor registers. */
    IDENTIFICATION(15);

    private final long nanos;

    NetworkTimer(int seconds) {
        nanos = TimeUnit.SECONDS.toNanos(seconds);
    }

    public long nanos() {
        return nanos;
    }
}
