package simgsm.center.msc.sms;

import static simgsm.center.msc.sms.OriginatingTransferTable.OriginatingAction.*;
import static simgsm.center.msc.sms.OriginatingTransferTable.OriginatingEvent.*;
import static simgsm.center.msc.sms.OriginatingTransferTable.OriginatingState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** A short message, or RP-SMMA, from a mobile on the network side (TS 24.011, 5 and 6). */
public final class OriginatingTransferTable {
    public enum OriginatingState {
        IDLE,
        /** The short message centre has RP-DATA. */
        WAIT_TO_SEND_RP_ACK,
        /** CP-DATA with RP-ACK or RP-ERROR is sent. */
        WAIT_FOR_CP_ACK,
        ENDED
    }

    public enum OriginatingEvent {
        CP_DATA_RECEIVED,
        CP_ACK_RECEIVED,
        CP_ERROR_RECEIVED,
        /** The short message centre has stored the message or refused it. */
        ANSWERED,
        TC1_EXPIRED,
        /** TC1* after the last repetition. */
        TC1_EXPIRED_AT_LAST,
        RADIO_LOST
    }

    public enum OriginatingAction {
        SEND_CP_ACK,
        SUBMIT,
        SEND_CP_DATA,
        /** The mobile has the answer, and will not repeat the message. */
        CONFIRM,
        END
    }

    private static final Set<OriginatingState> OPEN = EnumSet.complementOf(EnumSet.of(ENDED));

    public static final StateTable<OriginatingState, OriginatingEvent, OriginatingAction> ROWS = new StateTable<
                    OriginatingState, OriginatingEvent, OriginatingAction>("mobile-originated short message", IDLE)
            .on(IDLE, CP_DATA_RECEIVED, WAIT_TO_SEND_RP_ACK, SEND_CP_ACK, SUBMIT)
            .stay(EnumSet.of(WAIT_TO_SEND_RP_ACK, WAIT_FOR_CP_ACK), CP_DATA_RECEIVED, SEND_CP_ACK)
            .on(WAIT_TO_SEND_RP_ACK, ANSWERED, WAIT_FOR_CP_ACK, SEND_CP_DATA)
            .on(WAIT_FOR_CP_ACK, CP_ACK_RECEIVED, ENDED, CONFIRM, END)
            .stay(EnumSet.of(WAIT_FOR_CP_ACK), TC1_EXPIRED, SEND_CP_DATA)
            .on(WAIT_FOR_CP_ACK, TC1_EXPIRED_AT_LAST, ENDED, END)
            .on(OPEN, EnumSet.of(CP_ERROR_RECEIVED, RADIO_LOST), ENDED, END);

    private OriginatingTransferTable() {}
}
