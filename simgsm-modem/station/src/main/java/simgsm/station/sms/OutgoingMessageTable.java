package simgsm.station.sms;

import static simgsm.station.sms.OutgoingMessageTable.OutgoingMessageAction.*;
import static simgsm.station.sms.OutgoingMessageTable.OutgoingMessageEvent.*;
import static simgsm.station.sms.OutgoingMessageTable.OutgoingMessageState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** Submission of one short message by a mobile (TS 24.011, 5.3 and 6.3). */
public final class OutgoingMessageTable {
    /** SMC and SMR of the mobile for one outgoing message, in one machine (TS 24.011, 5.2 and 6.2). */
    public enum OutgoingMessageState {
        IDLE,
        MM_CONNECTION_PENDING,
        WAIT_FOR_CP_ACK,
        /** CP-ACK has arrived, RP-ACK has not. */
        WAIT_FOR_RP_ACK
    }

    /** Events of {@link OutgoingMessageTable}. */
    public enum OutgoingMessageEvent {
        SEND,
        MM_CONNECTED,
        MM_REFUSED,
        CP_ACK,
        CP_ERROR,
        RP_ACK,
        RP_ERROR,
        TC1_EXPIRED,
        /** After the last retransmission. */
        TC1_EXPIRED_FINALLY,
        TR1M_EXPIRED,
        /** No registration in time. */
        WAIT_EXPIRED,
        RADIO_LOST,
        /** The radio connection was lost more often than a message is repeated. */
        RADIO_LOST_FINALLY,
        POWER_OFF
    }

    /** Actions of {@link MessageSender}. */
    public enum OutgoingMessageAction {
        REQUEST_CONNECTION,
        RELEASE_CONNECTION,
        /** Ends the current connection; a request for the next one is kept. */
        COMPLETE_CONNECTION,
        SEND_CP_DATA,
        SEND_CP_ACK,
        START_WAIT,
        START_TC1,
        START_TR1M,
        STOP_TC1,
        STOP_TIMERS,
        /** The network may have the message: a repetition is marked (TP-RD). */
        MARK_REPEATED,
        REPORT_SENT,
        REPORT_FAILED,
        SEND_NEXT
    }

    private static final Set<OutgoingMessageState> IN_DIALOGUE = EnumSet.of(WAIT_FOR_CP_ACK, WAIT_FOR_RP_ACK);
    private static final Set<OutgoingMessageState> BUSY = EnumSet.complementOf(EnumSet.of(IDLE));

    public static final StateTable<OutgoingMessageState, OutgoingMessageEvent, OutgoingMessageAction> TABLE =
            new StateTable<>("outgoing short message", IDLE);

    static {
        TABLE.on(IDLE, SEND, MM_CONNECTION_PENDING, START_WAIT, REQUEST_CONNECTION);
        pending();
        dialogue();
        TABLE.on(BUSY, RADIO_LOST_FINALLY, IDLE, STOP_TIMERS, RELEASE_CONNECTION, REPORT_FAILED, SEND_NEXT)
                .on(BUSY, POWER_OFF, IDLE, STOP_TIMERS, RELEASE_CONNECTION, REPORT_FAILED, SEND_NEXT)
                .stay(EnumSet.of(IDLE), RADIO_LOST)
                .stay(EnumSet.of(IDLE), POWER_OFF);
    }

    private OutgoingMessageTable() {}

    private static void pending() {
        var pending = MM_CONNECTION_PENDING;
        TABLE.on(pending, MM_CONNECTED, WAIT_FOR_CP_ACK, STOP_TIMERS, START_TR1M, SEND_CP_DATA, START_TC1)
                .on(pending, MM_REFUSED, IDLE, STOP_TIMERS, REPORT_FAILED, SEND_NEXT)
                .on(pending, WAIT_EXPIRED, IDLE, RELEASE_CONNECTION, REPORT_FAILED, SEND_NEXT)
                .stay(EnumSet.of(pending), RADIO_LOST, REQUEST_CONNECTION);
    }

    private static void dialogue() {
        TABLE.on(WAIT_FOR_CP_ACK, CP_ACK, WAIT_FOR_RP_ACK, STOP_TC1)
                .stay(EnumSet.of(WAIT_FOR_CP_ACK), TC1_EXPIRED, SEND_CP_DATA, START_TC1);
        for (OutgoingMessageState state : IN_DIALOGUE) {
            // An answer without CP-ACK acknowledges as well. The request for the next message precedes the last
            // CP-ACK, so that the network keeps the channel (5.4).
            TABLE.on(state, RP_ACK, IDLE, STOP_TIMERS, COMPLETE_CONNECTION, REPORT_SENT, SEND_NEXT, SEND_CP_ACK)
                    .on(state, RP_ERROR, IDLE, STOP_TIMERS, COMPLETE_CONNECTION, REPORT_FAILED, SEND_NEXT, SEND_CP_ACK)
                    .on(state, CP_ERROR, IDLE, STOP_TIMERS, RELEASE_CONNECTION, REPORT_FAILED, SEND_NEXT)
                    .on(state, TR1M_EXPIRED, IDLE, STOP_TIMERS, RELEASE_CONNECTION, REPORT_FAILED, SEND_NEXT)
                    .on(
                            state,
                            RADIO_LOST,
                            MM_CONNECTION_PENDING,
                            STOP_TIMERS,
                            MARK_REPEATED,
                            START_WAIT,
                            REQUEST_CONNECTION);
        }
        TABLE.on(WAIT_FOR_CP_ACK, TC1_EXPIRED_FINALLY, IDLE, STOP_TIMERS, RELEASE_CONNECTION, REPORT_FAILED, SEND_NEXT);
    }
}
