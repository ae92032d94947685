package simgsm.station.call;

import static simgsm.station.call.MobileCallAction.*;
import static simgsm.station.call.MobileCallEvent.*;
import static simgsm.station.call.MobileCallState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** Call control of the mobile (TS 24.008, 5.2 and 5.4). */
public final class MobileCallTable {
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

    /** The call has ended for the user and not yet for the network. */
    static final Set<MobileCallState> CLEARING = EnumSet.of(DISCONNECT_REQUEST, DISCONNECT_INDICATION, RELEASE_REQUEST);

    public static final StateTable<MobileCallState, MobileCallEvent, MobileCallAction> TABLE =
            new StateTable<>("mobile call", NULL);

    static {
        originating();
        terminating();
        hold();
        clearingByMobile();
        clearingByNetwork();
        suddenEnds();
    }

    private MobileCallTable() {}

    /** 5.2.1. */
    private static void originating() {
        TABLE.on(NULL, DIAL, MM_CONNECTION_PENDING, REPORT_CALLING, START_T303, REQUEST_CONNECTION)
                .on(MM_CONNECTION_PENDING, MM_CONNECTED, CALL_INITIATED, SEND_SETUP)
                .on(MM_CONNECTION_PENDING, MM_REFUSED, NULL, STOP_TIMERS, REPORT_RELEASED, RELEASE_CONNECTION)
                .on(CALL_INITIATED, CALL_PROCEEDING, MO_CALL_PROCEEDING, STOP_TIMERS, START_T310)
                .stay(EnumSet.of(MO_CALL_PROCEEDING, CALL_DELIVERED), PROGRESS, STOP_TIMERS, ATTACH_USER);
        for (MobileCallState state : EnumSet.of(CALL_INITIATED, MO_CALL_PROCEEDING)) {
            TABLE.on(state, ALERTING, CALL_DELIVERED, STOP_TIMERS, ATTACH_USER, REPORT_ALERTED);
        }
        for (MobileCallState state : EnumSet.of(CALL_INITIATED, MO_CALL_PROCEEDING, CALL_DELIVERED)) {
            TABLE.on(state, CONNECT, ACTIVE, STOP_TIMERS, SEND_CONNECT_ACKNOWLEDGE, REPORT_CONNECTED, START_SPEECH);
        }
    }

    /** 5.2.2. */
    private static void terminating() {
        TABLE.on(NULL, SETUP, CALL_PRESENT, CHECK_COMPATIBILITY)
                // TS 24.083, 1: it was confirmed and alerted while the call before was active.
                .on(NULL, TAKE_WAITING, CALL_RECEIVED, REPORT_RINGING)
                .on(CALL_PRESENT, COMPATIBLE, MT_CALL_CONFIRMED, SEND_CALL_CONFIRMED, ALERT_USER)
                .on(MT_CALL_CONFIRMED, USER_ALERTED, CALL_RECEIVED, SEND_ALERTING, REPORT_RINGING)
                .on(CALL_RECEIVED, ANSWER, CONNECT_REQUEST, STOP_TIMERS, SEND_CONNECT, START_T313)
                .on(CONNECT_REQUEST, CONNECT_ACKNOWLEDGE, ACTIVE, STOP_TIMERS, REPORT_CONNECTED, START_SPEECH);
    }

    /** TS 24.083, 1 and 2: the held call waits elsewhere, see {@link CallHoldTable}. */
    private static void hold() {
        TABLE.on(ACTIVE, CALL_HELD, NULL, STOP_TIMERS, STOP_SPEECH, REPORT_HELD)
                .on(NULL, CALL_RETRIEVED, ACTIVE, REPORT_RETRIEVED, START_SPEECH)
                .on(NULL, ANSWER_WAITING, CONNECT_REQUEST, SEND_CONNECT, START_T313);
    }

    /** 5.4.3. */
    private static void clearingByMobile() {
        disconnect(SET_UP, CLEAR);
        disconnect(EnumSet.of(CALL_INITIATED), T303_EXPIRED);
        disconnect(EnumSet.of(MO_CALL_PROCEEDING), T310_EXPIRED);
        disconnect(EnumSet.of(CONNECT_REQUEST), T313_EXPIRED);
        TABLE.on(MM_CONNECTION_PENDING, CLEAR, NULL, STOP_TIMERS, REPORT_RELEASED, RELEASE_CONNECTION)
                .on(MM_CONNECTION_PENDING, T303_EXPIRED, NULL, STOP_TIMERS, REPORT_RELEASED, RELEASE_CONNECTION)
                .on(DISCONNECT_REQUEST, T305_EXPIRED, RELEASE_REQUEST, SEND_RELEASE, START_T308)
                .on(DISCONNECT_REQUEST, DISCONNECT, RELEASE_REQUEST, STOP_TIMERS, SEND_RELEASE, START_T308);
        for (MobileCallState state : EnumSet.of(DISCONNECT_REQUEST, DISCONNECT_INDICATION)) {
            TABLE.on(state, RELEASE, NULL, STOP_TIMERS, STOP_SPEECH, SEND_RELEASE_COMPLETE, RELEASE_CONNECTION);
        }
        TABLE.stay(EnumSet.of(RELEASE_REQUEST), T308_EXPIRED, SEND_RELEASE, START_T308_AGAIN)
                .on(RELEASE_REQUEST, T308_EXPIRED_AGAIN, NULL, RELEASE_CONNECTION);
    }

    private static void disconnect(Set<MobileCallState> states, MobileCallEvent event) {
        TABLE.on(
                states,
                event,
                DISCONNECT_REQUEST,
                STOP_TIMERS,
                STOP_SPEECH,
                SEND_DISCONNECT,
                START_T305,
                REPORT_RELEASED);
    }

    /** 5.4.4. */
    private static void clearingByNetwork() {
        TABLE.on(SET_UP, DISCONNECT, DISCONNECT_INDICATION, STOP_TIMERS, STOP_SPEECH, REPORT_RELEASED, CHECK_TONES)
                .on(DISCONNECT_INDICATION, NO_TONES_ANNOUNCED, RELEASE_REQUEST, SEND_RELEASE, START_T308)
                // 5.4.4.1.1.1: the user hears the network's tones and hangs up, or the network releases.
                .stay(EnumSet.of(DISCONNECT_INDICATION), TONES_ANNOUNCED, ATTACH_USER)
                .on(DISCONNECT_INDICATION, CLEAR, RELEASE_REQUEST, STOP_SPEECH, SEND_RELEASE, START_T308)
                .stay(EnumSet.of(RELEASE_REQUEST, DISCONNECT_INDICATION), DISCONNECT)
                // Release collision, 5.4.3.4: both sides have sent RELEASE, so neither answers.
                .on(RELEASE_REQUEST, RELEASE, NULL, STOP_TIMERS, RELEASE_CONNECTION);
        for (MobileCallState state : SET_UP) {
            TABLE.on(
                    state,
                    RELEASE,
                    NULL,
                    STOP_TIMERS,
                    STOP_SPEECH,
                    SEND_RELEASE_COMPLETE,
                    REPORT_RELEASED,
                    RELEASE_CONNECTION);
        }
    }

    /** 5.4.2, 5.5.3.2, and the loss of the radio connection or of power. */
    private static void suddenEnds() {
        for (MobileCallEvent event : EnumSet.of(RELEASE_COMPLETE, STATUS_NULL, RADIO_LOST)) {
            TABLE.on(SET_UP, event, NULL, STOP_TIMERS, STOP_SPEECH, REPORT_RELEASED, RELEASE_CONNECTION)
                    .on(CLEARING, event, NULL, STOP_TIMERS, STOP_SPEECH, RELEASE_CONNECTION);
        }
        TABLE.on(MM_CONNECTION_PENDING, RADIO_LOST, NULL, STOP_TIMERS, REPORT_RELEASED)
                .stay(EnumSet.of(NULL), RADIO_LOST)
                .on(CLEARING, POWER_OFF, NULL, STOP_TIMERS, STOP_SPEECH, RELEASE_CONNECTION)
                .on(MM_CONNECTION_PENDING, POWER_OFF, NULL, STOP_TIMERS, REPORT_RELEASED, RELEASE_CONNECTION)
                .stay(EnumSet.of(NULL), POWER_OFF);
        for (MobileCallState state : SET_UP) {
            TABLE.on(
                    state,
                    POWER_OFF,
                    NULL,
                    STOP_TIMERS,
                    STOP_SPEECH,
                    SEND_DISCONNECT,
                    REPORT_RELEASED,
                    RELEASE_CONNECTION);
        }
    }
}
