package simgsm.station.call;

import static simgsm.station.call.CallHoldTable.CallHoldAction.*;
import static simgsm.station.call.CallHoldTable.CallHoldEvent.*;
import static simgsm.station.call.CallHoldTable.CallHoldState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** Call hold of the mobile (TS 24.083, 2): the active call and the held one. */
public final class CallHoldTable {
    /** States: the request not yet answered by the network. */
    public enum CallHoldState {
        IDLE,
        HOLD_REQUEST,
        RETRIEVE_REQUEST,
        /** HOLD for the active call and RETRIEVE for the held one are sent. */
        SWAP_REQUEST,
        /** The active call is held already. */
        SWAP_HELD
    }

    /** Events. */
    public enum CallHoldEvent {
        USER_HOLDS,
        USER_RETRIEVES,
        USER_SWAPS,
        HOLD_ACKNOWLEDGE,
        HOLD_REJECT,
        RETRIEVE_ACKNOWLEDGE,
        RETRIEVE_REJECT,
        /** The network has not answered. */
        EXPIRED,
        /** The active call has ended. */
        ACTIVE_ENDED,
        /** The held call has ended. */
        HELD_ENDED,
        /** The network holds the active call after the time-out; there is no other call, or one waits. */
        HELD_LATE,
        /** As before, while the calls were being swapped. */
        SWAP_HELD_LATE,
        /** The network retrieves the held call after the time-out. */
        RETRIEVED_LATE,
        /** As before, while there is another call. */
        RETRIEVED_IN_VAIN
    }

    /** Actions. */
    public enum CallHoldAction {
        SEND_HOLD,
        SEND_RETRIEVE,
        START_TIMER,
        STOP_TIMER,
        /**
         * The active call becomes the held one; a waiting call rings, or is answered if the user has asked for it.
         */
        PARK,
        /** The held call becomes the active one. */
        RESUME,
        /** Swaps the two calls. */
        EXCHANGE,
        /** Ends the held call, which the network does not retrieve. */
        CLEAR_HELD,
        REPORT_REFUSED
    }

    private static final Set<CallHoldState> SWAPPING = EnumSet.of(SWAP_REQUEST, SWAP_HELD);

    public static final StateTable<CallHoldState, CallHoldEvent, CallHoldAction> TABLE =
            new StateTable<>("call hold", IDLE);

    static {
        TABLE.on(IDLE, USER_HOLDS, HOLD_REQUEST, SEND_HOLD, START_TIMER)
                .on(HOLD_REQUEST, HOLD_ACKNOWLEDGE, IDLE, STOP_TIMER, PARK)
                .on(HOLD_REQUEST, HOLD_REJECT, IDLE, STOP_TIMER, REPORT_REFUSED)
                .on(HOLD_REQUEST, EXPIRED, IDLE, REPORT_REFUSED)
                .on(HOLD_REQUEST, ACTIVE_ENDED, IDLE, STOP_TIMER)
                .on(IDLE, USER_RETRIEVES, RETRIEVE_REQUEST, SEND_RETRIEVE, START_TIMER)
                .on(RETRIEVE_REQUEST, RETRIEVE_ACKNOWLEDGE, IDLE, STOP_TIMER, RESUME)
                .on(RETRIEVE_REQUEST, RETRIEVE_REJECT, IDLE, STOP_TIMER, REPORT_REFUSED)
                .on(RETRIEVE_REQUEST, EXPIRED, IDLE, REPORT_REFUSED)
                .on(RETRIEVE_REQUEST, HELD_ENDED, IDLE, STOP_TIMER)
                .stay(EnumSet.of(RETRIEVE_REQUEST), HOLD_ACKNOWLEDGE)
                .on(IDLE, USER_SWAPS, SWAP_REQUEST, SEND_HOLD, SEND_RETRIEVE, START_TIMER)
                .on(SWAP_REQUEST, HOLD_ACKNOWLEDGE, SWAP_HELD)
                .on(SWAP_REQUEST, HOLD_REJECT, IDLE, STOP_TIMER, REPORT_REFUSED)
                .on(SWAP_REQUEST, EXPIRED, IDLE, REPORT_REFUSED)
                .on(SWAP_REQUEST, HELD_ENDED, HOLD_REQUEST)
                .on(SWAPPING, ACTIVE_ENDED, RETRIEVE_REQUEST)
                .on(SWAP_HELD, RETRIEVE_ACKNOWLEDGE, IDLE, STOP_TIMER, EXCHANGE)
                .on(SWAP_HELD, HELD_ENDED, IDLE, STOP_TIMER, PARK)
                .on(SWAP_HELD, RETRIEVE_REJECT, IDLE, STOP_TIMER, CLEAR_HELD, PARK, REPORT_REFUSED)
                .on(SWAP_HELD, EXPIRED, IDLE, CLEAR_HELD, PARK, REPORT_REFUSED)
                .stay(EnumSet.of(IDLE), ACTIVE_ENDED)
                .stay(EnumSet.of(IDLE), HELD_ENDED)
                // Late answers: the network has performed the request that was reported as failed.
                .on(IDLE, HELD_LATE, IDLE, PARK)
                .on(IDLE, SWAP_HELD_LATE, SWAP_HELD, START_TIMER)
                .on(IDLE, RETRIEVED_LATE, IDLE, RESUME)
                .on(IDLE, RETRIEVED_IN_VAIN, IDLE, CLEAR_HELD)
                .stay(EnumSet.of(IDLE), HOLD_ACKNOWLEDGE)
                .stay(EnumSet.of(IDLE), HOLD_REJECT)
                .stay(EnumSet.of(IDLE), RETRIEVE_ACKNOWLEDGE)
                .stay(EnumSet.of(IDLE), RETRIEVE_REJECT);
    }

    private CallHoldTable() {}
}
