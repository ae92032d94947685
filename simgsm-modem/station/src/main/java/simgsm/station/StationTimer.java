package simgsm.station;

import java.util.concurrent.TimeUnit;

/** Everything that a station waits for, by the specification's name; our own have none there and say so. */
enum StationTimer {
    /** LOCATION UPDATING REQUEST is answered (TS 24.008, table 11.1). */
    T3210(20_000),
    /** Pause before the next location updating (TS 24.008, table 11.1 has 15 s; ours starts short and grows). */
    T3211(1_000),
    /** IMSI DETACH INDICATION has been heard: the network releases (TS 24.008, table 11.1). */
    T3220(5_000),
    /** CM SERVICE REQUEST is answered (TS 24.008, table 11.1). */
    T3230(15_000),
    /** A radio connection that nobody uses is released by the network (TS 24.008, table 11.1). */
    T3240(10_000),
    /** SETUP is answered (TS 24.008, table 11.3). */
    T303(30_000),
    /** DISCONNECT is answered. */
    T305(30_000),
    /** RELEASE is answered; runs twice. */
    T308(30_000),
    /** CALL PROCEEDING is followed by ALERTING, CONNECT, PROGRESS or clearing. */
    T310(30_000),
    /** CONNECT is acknowledged. */
    T313(30_000),
    /** START DTMF is answered (TS 24.008, table 11.3). */
    T336(10_000),
    /** STOP DTMF is acknowledged. */
    T337(10_000),
    /** Ours: a signalled key has sounded long enough, or the pause behind it is over. */
    KEY(70),
    /** CP-DATA of an own message is acknowledged (TC1*, TS 24.011, 5.3.2.1, leaves the time to us). */
    TC1_OUTGOING(5_000),
    /** CP-DATA of our answer to a received message is acknowledged. */
    TC1_INCOMING(5_000),
    /** RP-DATA is answered (TS 24.011, 10: 35 to 45 s). */
    TR1M(40_000),
    /** Ours: the next speech frame is due. */
    SPEECH(20),
    /** Ours: the peer is asked whether it lives. */
    PING(30_000),
    /** Ours: a message waits for registration no longer than this. */
    MESSAGE_WAIT(40_000),
    /** Ours: the station's user is reminded of what it could not do. */
    REMINDER(30_000),
    /** Ours: a call waits for registration no longer than this; a caller at a silent phone gives up soon. */
    CALL_WAIT(5_000),
    /** Ours: how long a centre may take to ask who we are before we register unasked. */
    IDENTITY(2_000);

    private final long nanos;

    StationTimer(long millis) {
        nanos = TimeUnit.MILLISECONDS.toNanos(millis);
    }

    long nanos() {
        return nanos;
    }
}
