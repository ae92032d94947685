package simgsm.station.context;

import java.util.concurrent.TimeUnit;

/** The timers of the mobile side, named and valued as in the specifications; those without a clause are ours. */
public enum StationTimer {
    /** LOCATION UPDATING REQUEST is answered (TS 24.008, table 11.1). */
    T3210(20_000),
    /** Pause before the next location updating (TS 24.008, table 11.1); over the link to our own centre it begins at 1 s and doubles. */
    T3211(15_000),
    /** Periodic location updating (TS 24.008, table 11.1); the cell gives the time, in steps of 6 minutes. */
    T3212(360_000),
    /** The network releases the connection after IMSI DETACH INDICATION (TS 24.008, table 11.1). */
    T3220(5_000),
    /** CM SERVICE REQUEST is answered (TS 24.008, table 11.1). */
    T3230(15_000),
    /** An unused radio connection is released by the network (TS 24.008, table 11.1). */
    T3240(10_000),
    /** SETUP is answered (TS 24.008, table 11.3, as all of call control). */
    T303(30_000),
    /** DISCONNECT is answered. */
    T305(30_000),
    /** RELEASE is answered; runs twice. */
    T308(30_000),
    /** CALL PROCEEDING is followed by ALERTING, CONNECT, PROGRESS or clearing. */
    T310(30_000),
    /** CONNECT is acknowledged. */
    T313(30_000),
    /** HOLD or RETRIEVE is answered; the standard leaves the value open (TS 24.083, 2.1). */
    CALL_HOLD(10_000),
    /** START DTMF is answered. */
    T336(10_000),
    /** STOP DTMF is acknowledged. */
    T337(10_000),
    /** Least length of a signalled tone and of the pause after it (TS 23.014, 6), rounded up. */
    KEY(70),
    /** CP-DATA of an outgoing message is acknowledged (TC1*; TS 24.011, 5.3.2.1, leaves the value open). */
    TC1_OUTGOING(5_000),
    /** CP-DATA of the answer to a received message is acknowledged. */
    TC1_INCOMING(5_000),
    /** RP-DATA is answered (TS 24.011, 10: 35 to 45 s). */
    TR1M(40_000),
    /** Interval of speech frames. */
    SPEECH(20),
    /** Longest wait of a message for registration. */
    MESSAGE_WAIT(40_000),
    /** Delay of a reminder requested by the station's user. */
    REMINDER(30_000),
    /** Ringing time of an incoming call before its user is reminded to answer; the user sets it. */
    ANSWER(1_500),
    /** Longest wait of a call for registration: the caller hears nothing meanwhile. */
    CALL_WAIT(5_000),
    /** Longest wait of a USSD request for registration: its user looks at the display meanwhile. */
    SERVICE_WAIT(5_000),
    /** Time-out of the network's answer to a USSD request or reply; ours, above the network's own limits. */
    SERVICE_ANSWER(120_000),
    /** Time without IDENTITY REQUEST after which the station registers unasked. */
    IDENTITY(2_000);

    private final long nanos;

    StationTimer(long millis) {
        nanos = TimeUnit.MILLISECONDS.toNanos(millis);
    }

    public long nanos() {
        return nanos;
    }
}
