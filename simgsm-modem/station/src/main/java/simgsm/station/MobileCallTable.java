package simgsm.station;

import static simgsm.station.MobileCallAction.*;
import static simgsm.station.MobileCallEvent.*;
import static simgsm.station.MobileCallState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** Call control of the mobile (TS 24.008, 5.2 and 5.4): one row a line of the standard. */
final class MobileCallTable {
    /** From the first message of a call until its clearing begins. */
    static final Set<MobileCallState> SET_UP = EnumSet.of(
            CALL_INITIATED,
            MO_CALL_PROCEEDING,
            CALL_DELIVERED,
            CALL_PRESENT,
            CALL_RECEIVED,
            CONNECT_REQUEST,
            MT_CALL_CONFIRMED,
            ACTIVE);

    /** The user has let go of the call, the network not yet. */
    static final Set<MobileCallState> CLEARING = EnumSet.of(DISCONNECT_REQUEST, DISCONNECT_INDICATION, RELEASE_REQUEST);

    static final StateTable<MobileCallState, MobileCallEvent, MobileCallAction> ROWS =
            new StateTable<>("mobile call", NULL);

    static {
        originating();
        terminating();
        clearingByUs();
        clearingByNetwork();
        suddenEnds();
    }

    private MobileCallTable() {}

    /** 5.2.1. */
    private static void originating() {
        ROWS.on(EnumSet.of(NULL), DIAL, MM_CONNECTION_PENDING, TELL_CALLING, START_T303, REQUEST_CONNECTION)
                .on(EnumSet.of(MM_CONNECTION_PENDING), MM_CONNECTED, CALL_INITIATED, SEND_SETUP)
                .on(EnumSet.of(MM_CONNECTION_PENDING), MM_REFUSED, NULL, STOP_TIMERS, TELL_RELEASED, RELEASE_CONNECTION)
                .on(EnumSet.of(CALL_INITIATED), CALL_PROCEEDING, MO_CALL_PROCEEDING, STOP_TIMERS, START_T310)
                .stay(EnumSet.of(MO_CALL_PROCEEDING, CALL_DELIVERED), PROGRESS, STOP_TIMERS, ATTACH_USER)
                .on(
                        EnumSet.of(CALL_INITIATED, MO_CALL_PROCEEDING),
                        ALERTING,
                        CALL_DELIVERED,
                        STOP_TIMERS,
                        ATTACH_USER,
                        TELL_ALERTING)
                .on(
                        EnumSet.of(CALL_INITIATED, MO_CALL_PROCEEDING, CALL_DELIVERED),
                        CONNECT,
                        ACTIVE,
                        STOP_TIMERS,
                        SEND_CONNECT_ACKNOWLEDGE,
                        TELL_CONNECTED,
                        START_SPEECH);
    }

    /** 5.2.2. */
    private static void terminating() {
        ROWS.on(EnumSet.of(NULL), SETUP, CALL_PRESENT, CHECK_COMPATIBILITY)
                // TS 24.083, 1: it was confirmed and alerted while the call before was under way.
                .on(EnumSet.of(NULL), TAKE_WAITING, CALL_RECEIVED, TELL_RINGING)
                .on(EnumSet.of(CALL_PRESENT), COMPATIBLE, MT_CALL_CONFIRMED, SEND_CALL_CONFIRMED, ALERT_USER)
                .on(EnumSet.of(MT_CALL_CONFIRMED), USER_ALERTED, CALL_RECEIVED, SEND_ALERTING, TELL_RINGING)
                .on(EnumSet.of(CALL_RECEIVED), ANSWER, CONNECT_REQUEST, SEND_CONNECT, START_T313)
                .on(
                        EnumSet.of(CONNECT_REQUEST),
                        CONNECT_ACKNOWLEDGE,
                        ACTIVE,
                        STOP_TIMERS,
                        TELL_CONNECTED,
                        START_SPEECH);
    }

    /** 5.4.3. */
    private static void clearingByUs() {
        for (MobileCallEvent event : EnumSet.of(CLEAR, T303_EXPIRED, T310_EXPIRED, T313_EXPIRED)) {
            ROWS.on(
                    statesFor(event),
                    event,
                    DISCONNECT_REQUEST,
                    STOP_TIMERS,
                    STOP_SPEECH,
                    SEND_DISCONNECT,
                    START_T305,
                    TELL_RELEASED);
        }
        for (MobileCallEvent event : EnumSet.of(CLEAR, T303_EXPIRED)) {
            ROWS.on(EnumSet.of(MM_CONNECTION_PENDING), event, NULL, STOP_TIMERS, TELL_RELEASED, RELEASE_CONNECTION);
        }
        ROWS.on(EnumSet.of(DISCONNECT_REQUEST), T305_EXPIRED, RELEASE_REQUEST, SEND_RELEASE, START_T308)
                .on(EnumSet.of(DISCONNECT_REQUEST), DISCONNECT, RELEASE_REQUEST, STOP_TIMERS, SEND_RELEASE, START_T308)
                .on(
                        EnumSet.of(DISCONNECT_REQUEST, DISCONNECT_INDICATION),
                        RELEASE,
                        NULL,
                        STOP_TIMERS,
                        STOP_SPEECH,
                        SEND_RELEASE_COMPLETE,
                        RELEASE_CONNECTION)
                .stay(EnumSet.of(RELEASE_REQUEST), T308_EXPIRED, SEND_RELEASE, START_T308_AGAIN)
                .on(EnumSet.of(RELEASE_REQUEST), T308_EXPIRED_AGAIN, NULL, RELEASE_CONNECTION);
    }

    private static Set<MobileCallState> statesFor(MobileCallEvent event) {
        return switch (event) {
            case T303_EXPIRED -> EnumSet.of(CALL_INITIATED);
            case T310_EXPIRED -> EnumSet.of(MO_CALL_PROCEEDING);
            case T313_EXPIRED -> EnumSet.of(CONNECT_REQUEST);
            default -> SET_UP;
        };
    }

    /** 5.4.4. */
    private static void clearingByNetwork() {
        ROWS.on(SET_UP, DISCONNECT, DISCONNECT_INDICATION, STOP_TIMERS, STOP_SPEECH, TELL_RELEASED, LISTEN_FOR_TONES)
                .on(EnumSet.of(DISCONNECT_INDICATION), NOTHING_TO_HEAR, RELEASE_REQUEST, SEND_RELEASE, START_T308)
                // 5.4.4.1.1.1: the network's tones are heard until the user has heard enough, or the network releases.
                .stay(EnumSet.of(DISCONNECT_INDICATION), TONES_TO_HEAR, ATTACH_USER)
                .on(EnumSet.of(DISCONNECT_INDICATION), CLEAR, RELEASE_REQUEST, STOP_SPEECH, SEND_RELEASE, START_T308)
                .stay(EnumSet.of(RELEASE_REQUEST, DISCONNECT_INDICATION), DISCONNECT)
                .on(
                        SET_UP,
                        RELEASE,
                        NULL,
                        STOP_TIMERS,
                        STOP_SPEECH,
                        SEND_RELEASE_COMPLETE,
                        TELL_RELEASED,
                        RELEASE_CONNECTION)
                // Release collision, 5.4.3.4: both sides have asked, nobody need answer.
                .on(EnumSet.of(RELEASE_REQUEST), RELEASE, NULL, STOP_TIMERS, RELEASE_CONNECTION);
    }

    /** 5.4.2, 5.5.3.2, and the loss of the radio or of power. */
    private static void suddenEnds() {
        for (MobileCallEvent event : EnumSet.of(RELEASE_COMPLETE, STATUS_NULL, RADIO_LOST)) {
            ROWS.on(SET_UP, event, NULL, STOP_TIMERS, STOP_SPEECH, TELL_RELEASED, RELEASE_CONNECTION)
                    .on(CLEARING, event, NULL, STOP_TIMERS, STOP_SPEECH, RELEASE_CONNECTION);
        }
        ROWS.on(EnumSet.of(MM_CONNECTION_PENDING), RADIO_LOST, NULL, STOP_TIMERS, TELL_RELEASED)
                .stay(EnumSet.of(NULL), RADIO_LOST)
                .on(
                        SET_UP,
                        POWER_OFF,
                        NULL,
                        STOP_TIMERS,
                        STOP_SPEECH,
                        SEND_DISCONNECT,
                        TELL_RELEASED,
                        RELEASE_CONNECTION)
                .on(CLEARING, POWER_OFF, NULL, STOP_TIMERS, STOP_SPEECH, RELEASE_CONNECTION)
                .on(EnumSet.of(MM_CONNECTION_PENDING), POWER_OFF, NULL, STOP_TIMERS, TELL_RELEASED, RELEASE_CONNECTION)
                .stay(EnumSet.of(NULL), POWER_OFF);
    }
}
