package simgsm.station;

import static simgsm.station.OutgoingAction.*;
import static simgsm.station.OutgoingEvent.*;
import static simgsm.station.OutgoingState.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;

/** How one short message goes up (TS 24.011, 5.3 and 6.3). */
final class OutgoingTable {
    private static final Set<OutgoingState> IN_DIALOGUE = EnumSet.of(WAIT_FOR_CP_ACK, WAIT_FOR_RP_ACK);
    private static final Set<OutgoingState> UNDER_WAY = EnumSet.complementOf(EnumSet.of(IDLE));

    static final StateTable<OutgoingState, OutgoingEvent, OutgoingAction> ROWS = new StateTable<
                    OutgoingState, OutgoingEvent, OutgoingAction>("outgoing short message", OutgoingState.IDLE)
            .on(EnumSet.of(IDLE), SEND, MM_CONNECTION_PENDING, START_WAIT, REQUEST_CONNECTION)
            .on(
                    EnumSet.of(MM_CONNECTION_PENDING),
                    MM_CONNECTED,
                    WAIT_FOR_CP_ACK,
                    STOP_TIMERS,
                    START_TR1M,
                    SEND_CP_DATA,
                    START_TC1)
            .on(EnumSet.of(MM_CONNECTION_PENDING), MM_REFUSED, IDLE, STOP_TIMERS, TELL_FAILED, SEND_NEXT)
            .on(EnumSet.of(MM_CONNECTION_PENDING), WAIT_EXPIRED, IDLE, RELEASE_CONNECTION, TELL_FAILED, SEND_NEXT)
            .on(EnumSet.of(WAIT_FOR_CP_ACK), CP_ACK, WAIT_FOR_RP_ACK, STOP_TC1)
            .stay(EnumSet.of(WAIT_FOR_CP_ACK), TC1_EXPIRED, SEND_CP_DATA, START_TC1)
            // An answer without CP-ACK acknowledges as well. The next message's request goes before the last
            // CP-ACK, so that the network keeps the channel (5.4).
            .on(IN_DIALOGUE, RP_ACK, IDLE, STOP_TIMERS, END_CONNECTION, TELL_SENT, SEND_NEXT, SEND_CP_ACK)
            .on(IN_DIALOGUE, RP_ERROR, IDLE, STOP_TIMERS, END_CONNECTION, TELL_FAILED, SEND_NEXT, SEND_CP_ACK)
            .on(IN_DIALOGUE, CP_ERROR, IDLE, STOP_TIMERS, RELEASE_CONNECTION, TELL_FAILED, SEND_NEXT)
            .on(
                    EnumSet.of(WAIT_FOR_CP_ACK),
                    TC1_EXPIRED_FINALLY,
                    IDLE,
                    STOP_TIMERS,
                    RELEASE_CONNECTION,
                    TELL_FAILED,
                    SEND_NEXT)
            .on(IN_DIALOGUE, TR1M_EXPIRED, IDLE, STOP_TIMERS, RELEASE_CONNECTION, TELL_FAILED, SEND_NEXT)
            .on(
                    IN_DIALOGUE,
                    RADIO_LOST,
                    MM_CONNECTION_PENDING,
                    STOP_TIMERS,
                    MARK_REPEATED,
                    START_WAIT,
                    REQUEST_CONNECTION)
            .stay(EnumSet.of(MM_CONNECTION_PENDING), RADIO_LOST, REQUEST_CONNECTION)
            .on(UNDER_WAY, RADIO_LOST_FINALLY, IDLE, STOP_TIMERS, RELEASE_CONNECTION, TELL_FAILED, SEND_NEXT)
            .on(UNDER_WAY, POWER_OFF, IDLE, STOP_TIMERS, RELEASE_CONNECTION, TELL_FAILED, SEND_NEXT)
            .stay(EnumSet.of(IDLE), RADIO_LOST)
            .stay(EnumSet.of(IDLE), POWER_OFF);

    private OutgoingTable() {}
}
