package simgsm.station.ss;

import static simgsm.station.ss.MobileUssdTable.MobileUssdAction.*;
import static simgsm.station.ss.MobileUssdTable.MobileUssdEvent.*;
import static simgsm.station.ss.MobileUssdTable.MobileUssdState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** One USSD dialogue of a mobile, begun by its user or by the network (TS 24.090, 5 and 6). */
public final class MobileUssdTable {
    /** States. */
    public enum MobileUssdState {
        IDLE,
        /** The user's request waits for a connection. */
        MM_CONNECTION_PENDING,
        WAIT_FOR_NETWORK,
        /** The network has asked the user. */
        WAIT_FOR_USER
    }

    /** Events. */
    public enum MobileUssdEvent {
        USER_REQUESTS,
        USER_REPLIES,
        USER_ENDS,
        MM_CONNECTED,
        MM_REFUSED,
        /** unstructuredSS-Request. */
        NETWORK_ASKS,
        /** unstructuredSS-Notify. */
        NETWORK_NOTIFIES,
        /** RELEASE COMPLETE, with or without a component. */
        NETWORK_ENDS,
        /** No registration in time. */
        WAIT_EXPIRED,
        /** The network does not answer. */
        ANSWER_EXPIRED,
        RADIO_LOST,
        POWER_OFF
    }

    /** Actions. */
    public enum MobileUssdAction {
        REQUEST_CONNECTION,
        ADOPT_CONNECTION,
        RELEASE_CONNECTION,
        SEND_REQUEST,
        SEND_REPLY,
        /** The user has seen a text. */
        SEND_CONFIRMATION,
        SEND_RELEASE_COMPLETE,
        START_WAIT,
        START_ANSWER,
        STOP_TIMERS,
        /** Shows the network's text. */
        SHOW_TEXT,
        /** Shows the last text, or the dialogue's ending without one. */
        REPORT_END
    }

    private static final Set<MobileUssdState> IN_DIALOGUE = EnumSet.of(WAIT_FOR_NETWORK, WAIT_FOR_USER);

    public static final StateTable<MobileUssdState, MobileUssdEvent, MobileUssdAction> TABLE =
            new StateTable<>("USSD of the mobile", IDLE);

    static {
        TABLE.on(IDLE, USER_REQUESTS, MM_CONNECTION_PENDING, START_WAIT, REQUEST_CONNECTION)
                .on(IDLE, NETWORK_ASKS, WAIT_FOR_USER, ADOPT_CONNECTION, SHOW_TEXT)
                .on(
                        IDLE,
                        NETWORK_NOTIFIES,
                        WAIT_FOR_NETWORK,
                        ADOPT_CONNECTION,
                        SHOW_TEXT,
                        SEND_CONFIRMATION,
                        START_ANSWER)
                .stay(EnumSet.of(IDLE), RADIO_LOST)
                .stay(EnumSet.of(IDLE), POWER_OFF);
        pending();
        dialogue();
    }

    private MobileUssdTable() {}

    private static void pending() {
        var pending = MM_CONNECTION_PENDING;
        TABLE.on(pending, MM_CONNECTED, WAIT_FOR_NETWORK, STOP_TIMERS, SEND_REQUEST, START_ANSWER)
                .on(pending, MM_REFUSED, IDLE, STOP_TIMERS, REPORT_END)
                .on(
                        EnumSet.of(pending),
                        EnumSet.of(WAIT_EXPIRED, USER_ENDS, POWER_OFF),
                        IDLE,
                        STOP_TIMERS,
                        RELEASE_CONNECTION,
                        REPORT_END)
                .stay(EnumSet.of(pending), RADIO_LOST, REQUEST_CONNECTION);
    }

    private static void dialogue() {
        TABLE.on(WAIT_FOR_NETWORK, NETWORK_ASKS, WAIT_FOR_USER, STOP_TIMERS, SHOW_TEXT)
                .stay(EnumSet.of(WAIT_FOR_NETWORK), NETWORK_NOTIFIES, SHOW_TEXT, SEND_CONFIRMATION, START_ANSWER)
                .on(WAIT_FOR_USER, USER_REPLIES, WAIT_FOR_NETWORK, SEND_REPLY, START_ANSWER)
                .on(IN_DIALOGUE, NETWORK_ENDS, IDLE, STOP_TIMERS, RELEASE_CONNECTION, REPORT_END)
                .on(IN_DIALOGUE, USER_ENDS, IDLE, STOP_TIMERS, SEND_RELEASE_COMPLETE, RELEASE_CONNECTION, REPORT_END)
                .on(WAIT_FOR_NETWORK, ANSWER_EXPIRED, IDLE, SEND_RELEASE_COMPLETE, RELEASE_CONNECTION, REPORT_END)
                .on(IN_DIALOGUE, EnumSet.of(RADIO_LOST, POWER_OFF), IDLE, STOP_TIMERS, RELEASE_CONNECTION, REPORT_END);
    }
}
