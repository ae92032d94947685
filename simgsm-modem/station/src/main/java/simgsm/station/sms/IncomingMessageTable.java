package simgsm.station.sms;

import static simgsm.station.sms.IncomingMessageTable.IncomingMessageAction.*;
import static simgsm.station.sms.IncomingMessageTable.IncomingMessageEvent.*;
import static simgsm.station.sms.IncomingMessageTable.IncomingMessageState.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/** Reception of messages by a mobile (TS 24.011, 5.3 and 6.3): each CP-DATA is answered at once. */
public final class IncomingMessageTable {
    /** SMC of the mobile for the answer to one incoming message (TS 24.011, 5.2). */
    public enum IncomingMessageState {
        IDLE,
        /** CP-DATA with the answer is sent. */
        WAIT_FOR_CP_ACK
    }

    /** Events of {@link IncomingMessageTable}. */
    public enum IncomingMessageEvent {
        CP_DATA,
        /** The CP-DATA was answered before. */
        CP_DATA_REPEATED,
        CP_ACK,
        CP_ERROR,
        TC1_EXPIRED,
        /** After the last retransmission. */
        TC1_EXPIRED_FINALLY,
        RADIO_LOST
    }

    /** Actions of {@link MessageReceiver}. */
    public enum IncomingMessageAction {
        SEND_CP_ACK,
        /** Accepts or refuses the message and prepares the answer. */
        TAKE_MESSAGE,
        SEND_ANSWER,
        START_TC1,
        STOP_TC1,
        /** The network may lack the answer and deliver the message again. */
        EXPECT_DUPLICATE
    }

    public static final StateTable<IncomingMessageState, IncomingMessageEvent, IncomingMessageAction> TABLE =
            new StateTable<>("incoming short message", IDLE);

    static {
        var waiting = WAIT_FOR_CP_ACK;
        TABLE.on(IDLE, CP_DATA, waiting, SEND_CP_ACK, TAKE_MESSAGE, START_TC1, SEND_ANSWER)
                .stay(EnumSet.of(IDLE), RADIO_LOST)
                .stay(EnumSet.of(waiting), CP_DATA_REPEATED, SEND_CP_ACK)
                // The next message without CP-ACK: the network has not received the last answer.
                .on(waiting, CP_DATA, waiting, SEND_CP_ACK, EXPECT_DUPLICATE, TAKE_MESSAGE, START_TC1, SEND_ANSWER)
                .on(waiting, CP_ACK, IDLE, STOP_TC1)
                // The network has given the transaction up.
                .on(waiting, CP_ERROR, IDLE, STOP_TC1, EXPECT_DUPLICATE)
                .stay(EnumSet.of(waiting), TC1_EXPIRED, START_TC1, SEND_ANSWER)
                .on(waiting, TC1_EXPIRED_FINALLY, IDLE, EXPECT_DUPLICATE)
                .on(waiting, RADIO_LOST, IDLE, STOP_TC1, EXPECT_DUPLICATE);
    }

    private IncomingMessageTable() {}
}
