package simgsm.center.msc.sms;

import static simgsm.center.msc.sms.TerminatingTransferTable.TerminatingAction.*;
import static simgsm.center.msc.sms.TerminatingTransferTable.TerminatingEvent.*;
import static simgsm.center.msc.sms.TerminatingTransferTable.TerminatingState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** A short message to a mobile on the network side (TS 24.011, 5 and 6). */
public final class TerminatingTransferTable {
    public enum TerminatingState {
        /** The mobile is being paged. */
        MM_CONNECTION_PENDING,
        WAIT_FOR_CP_ACK,
        WAIT_FOR_RP_ACK,
        ENDED
    }

    public enum TerminatingEvent {
        RADIO_CONNECTED,
        PAGING_FAILED,
        CP_ACK_RECEIVED,
        /** CP-DATA with RP-ACK. */
        RP_ACK_RECEIVED,
        /** CP-DATA with RP-ERROR, cause 22. */
        MEMORY_EXCEEDED_RECEIVED,
        /** CP-DATA with RP-ERROR, any other cause. */
        RP_ERROR_RECEIVED,
        /** CP-DATA with any other content, or another RP reference. */
        OTHER_CP_DATA_RECEIVED,
        CP_ERROR_RECEIVED,
        TC1_EXPIRED,
        /** TC1* after the last repetition. */
        TC1_EXPIRED_AT_LAST,
        TR1N_EXPIRED,
        RADIO_LOST
    }

    public enum TerminatingAction {
        START_TR1N,
        SEND_CP_DATA,
        STOP_TC1,
        SEND_CP_ACK,
        END_DELIVERED,
        END_MEMORY_FULL,
        END_REFUSED,
        END_ABSENT,
        END_FAILED
    }

    private static final Set<TerminatingState> CONNECTED = EnumSet.of(WAIT_FOR_CP_ACK, WAIT_FOR_RP_ACK);

    public static final StateTable<TerminatingState, TerminatingEvent, TerminatingAction> ROWS = new StateTable<
                    TerminatingState, TerminatingEvent, TerminatingAction>(
                    "mobile-terminated short message", MM_CONNECTION_PENDING)
            .on(MM_CONNECTION_PENDING, RADIO_CONNECTED, WAIT_FOR_CP_ACK, START_TR1N, SEND_CP_DATA)
            .on(EnumSet.of(MM_CONNECTION_PENDING), EnumSet.of(PAGING_FAILED, RADIO_LOST), ENDED, END_ABSENT)
            .stay(EnumSet.of(WAIT_FOR_CP_ACK), TC1_EXPIRED, SEND_CP_DATA)
            .on(CONNECTED, CP_ACK_RECEIVED, WAIT_FOR_RP_ACK, STOP_TC1)
            .on(CONNECTED, RP_ACK_RECEIVED, ENDED, SEND_CP_ACK, END_DELIVERED)
            .on(CONNECTED, MEMORY_EXCEEDED_RECEIVED, ENDED, SEND_CP_ACK, END_MEMORY_FULL)
            .on(CONNECTED, RP_ERROR_RECEIVED, ENDED, SEND_CP_ACK, END_REFUSED)
            .on(CONNECTED, OTHER_CP_DATA_RECEIVED, WAIT_FOR_RP_ACK, STOP_TC1, SEND_CP_ACK)
            .on(
                    CONNECTED,
                    EnumSet.of(CP_ERROR_RECEIVED, TC1_EXPIRED_AT_LAST, TR1N_EXPIRED, RADIO_LOST),
                    ENDED,
                    END_FAILED);

    private TerminatingTransferTable() {}
}
