package simgsm.modem.client;

import static simgsm.modem.client.AttachedCallTable.AttachedCallPhase.*;
import static simgsm.modem.client.AttachedCallTable.CallAction.*;
import static simgsm.modem.client.AttachedCallTable.CallEvent.*;

import java.util.EnumSet;
import java.util.Set;
import simgsm.state.StateTable;
import simgsm.station.call.MobileCallTable.MobileCallState;

/** The one call of an attached modem: it rings, is answered, and ends. */
final class AttachedCallTable {
    enum AttachedCallPhase {
        IDLE(MobileCallState.NULL),
        RINGING(MobileCallState.CALL_RECEIVED),
        /** {@code ATA} waits for its result. */
        ANSWERING(MobileCallState.CONNECT_REQUEST),
        ACTIVE(MobileCallState.ACTIVE),
        /** Ended for the robot, not yet for the modem. */
        HANGING_UP(MobileCallState.DISCONNECT_REQUEST);

        private final MobileCallState shown;

        AttachedCallPhase(MobileCallState shown) {
            this.shown = shown;
        }

        /** The corresponding state of a mobile station's call, for snapshots. */
        MobileCallState shown() {
            return shown;
        }
    }

    enum CallEvent {
        RING,
        /** The modem has listed its calls. */
        CALLER_KNOWN,
        ANSWER_DUE,
        ANSWERED,
        HANG_UP,
        HUNG_UP,
        /** Cleared by the caller or the network. */
        CLEARED,
        /** The modem is lost, or has restarted. */
        MODEM_LOST
    }

    enum CallAction {
        ASK_CALLER,
        /** The call has ended unseen if no further RING follows. */
        START_RING_GUARD,
        REPORT_RINGING,
        START_ANSWER_TIMER,
        SEND_ANSWER,
        BEGIN,
        SEND_HANG_UP,
        REPORT_RELEASED,
        STOP_TIMERS
    }

    static final Set<AttachedCallPhase> STANDING = EnumSet.of(RINGING, ANSWERING, ACTIVE);

    static final StateTable<AttachedCallPhase, CallEvent, CallAction> TABLE = new StateTable<
                    AttachedCallPhase, CallEvent, CallAction>("call of an attached modem", IDLE)
            .on(IDLE, RING, RINGING, START_RING_GUARD, ASK_CALLER)
            .stay(EnumSet.of(RINGING), RING, START_RING_GUARD)
            .stay(EnumSet.of(RINGING), CALLER_KNOWN, REPORT_RINGING, START_ANSWER_TIMER)
            .on(RINGING, ANSWER_DUE, ANSWERING, STOP_TIMERS, SEND_ANSWER)
            .on(ANSWERING, ANSWERED, ACTIVE, BEGIN)
            .on(STANDING, HANG_UP, HANGING_UP, STOP_TIMERS, SEND_HANG_UP, REPORT_RELEASED)
            .on(STANDING, EnumSet.of(CLEARED, MODEM_LOST), IDLE, STOP_TIMERS, REPORT_RELEASED)
            .on(EnumSet.of(HANGING_UP), EnumSet.of(HUNG_UP, MODEM_LOST), IDLE)
            .stay(EnumSet.of(HANGING_UP), CLEARED);

    private AttachedCallTable() {}
}
