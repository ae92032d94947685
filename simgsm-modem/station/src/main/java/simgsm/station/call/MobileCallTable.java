package simgsm.station.call;

import static simgsm.station.call.MobileCallTable.MobileCallAction.*;
import static simgsm.station.call.MobileCallTable.MobileCallEvent.*;
import static simgsm.station.call.MobileCallTable.MobileCallState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;
import simgsm.station.context.StationTimer;

/** Call control of the mobile (TS 24.008, 5.2 and 5.4). */
public final class MobileCallTable {
    /** The mobile's call states (TS 24.008, 5.1.2.1), with the codes of STATUS (10.5.4.6). */
    public enum MobileCallState {
        NULL(0),
        MM_CONNECTION_PENDING(0),
        CALL_INITIATED(1),
        MO_CALL_PROCEEDING(3),
        CALL_DELIVERED(4),
        CALL_PRESENT(6),
        CALL_RECEIVED(7),
        CONNECT_REQUEST(8),
        MT_CALL_CONFIRMED(9),
        ACTIVE(10),
        DISCONNECT_REQUEST(11),
        DISCONNECT_INDICATION(12),
        RELEASE_REQUEST(19);

        private final int code;

        MobileCallState(int code) {
            this.code = code;
        }

        /** Call state value of STATUS, 0 to 63. */
        public int code() {
            return code;
        }
    }

    /** Events of {@link MobileCallTable}: commands of the user, the radio connection, messages of the network, timers. */
    public enum MobileCallEvent {
        DIAL,
        ANSWER,
        CLEAR,
        POWER_OFF,

        MM_CONNECTED,
        MM_REFUSED,
        RADIO_LOST,

        SETUP,
        /** A waiting call, already alerted, becomes the current call. */
        TAKE_WAITING,
        /** A waiting call becomes the current call and is answered at once. */
        ANSWER_WAITING,
        /** The network holds the active call; another one may become the current one. */
        CALL_HELD,
        /** The network retrieves the held call. */
        CALL_RETRIEVED,
        /** The offered call is a speech call, like all calls here. */
        COMPATIBLE,
        /** The terminal rings. */
        USER_ALERTED,
        CALL_PROCEEDING,
        PROGRESS,
        ALERTING,
        CONNECT,
        CONNECT_ACKNOWLEDGE,
        DISCONNECT,
        /** DISCONNECT without in-band tones: the call is released at once. */
        NO_TONES_ANNOUNCED,
        /** DISCONNECT with in-band tones, which are heard first. */
        TONES_ANNOUNCED,
        RELEASE,
        RELEASE_COMPLETE,
        /** STATUS: the network is in state N0. */
        STATUS_NULL,

        T303_EXPIRED,
        T305_EXPIRED,
        T308_EXPIRED,
        /** The second expiry. */
        T308_EXPIRED_AGAIN,
        T310_EXPIRED,
        T313_EXPIRED
    }

    /** Actions of {@link MobileCall}. */
    public enum MobileCallAction {
        REQUEST_CONNECTION,
        RELEASE_CONNECTION,
        SEND_SETUP,
        SEND_CALL_CONFIRMED,
        SEND_ALERTING,
        SEND_CONNECT,
        SEND_CONNECT_ACKNOWLEDGE,
        SEND_DISCONNECT,
        SEND_RELEASE,
        SEND_RELEASE_COMPLETE,
        START_T303,
        START_T305,
        START_T308,
        START_T308_AGAIN,
        START_T310,
        START_T313,
        STOP_TIMERS,
        /** If the message announces tones of the network, opens the speech path for them (5.5.1). */
        ATTACH_USER,
        START_SPEECH,
        STOP_SPEECH,
        REPORT_CALLING,
        REPORT_ALERTED,
        REPORT_RINGING,
        REPORT_CONNECTED,
        REPORT_HELD,
        REPORT_RETRIEVED,
        REPORT_RELEASED,
        CHECK_COMPATIBILITY,
        ALERT_USER,
        /** Fires TONES_ANNOUNCED or NO_TONES_ANNOUNCED. */
        CHECK_TONES
    }

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

    /** The call has ended for the user, but not yet for the network. */
    static final Set<MobileCallState> CLEARING = EnumSet.of(DISCONNECT_REQUEST, DISCONNECT_INDICATION, RELEASE_REQUEST);

    /** Timers of a call, and of the wait for service before it. */
    static final StationTimer[] TIMERS = {
        StationTimer.CALL_WAIT,
        StationTimer.ANSWER,
        StationTimer.T303,
        StationTimer.T305,
        StationTimer.T308,
        StationTimer.T310,
        StationTimer.T313
    };

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
                // TS 24.083, 1: the call was confirmed and alerted while the previous one was active.
                .on(NULL, TAKE_WAITING, CALL_RECEIVED, REPORT_RINGING)
                .on(CALL_PRESENT, COMPATIBLE, MT_CALL_CONFIRMED, SEND_CALL_CONFIRMED, ALERT_USER)
                .on(MT_CALL_CONFIRMED, USER_ALERTED, CALL_RECEIVED, SEND_ALERTING, REPORT_RINGING)
                .on(CALL_RECEIVED, ANSWER, CONNECT_REQUEST, STOP_TIMERS, SEND_CONNECT, START_T313)
                .on(CONNECT_REQUEST, CONNECT_ACKNOWLEDGE, ACTIVE, STOP_TIMERS, REPORT_CONNECTED, START_SPEECH);
    }

    /** TS 24.083, 1 and 2: the held call is kept by {@link CallHoldTable}. */
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
