package simgsm.station.call;

import static simgsm.station.call.KeySignallingTable.KeySignallingAction.*;
import static simgsm.station.call.KeySignallingTable.KeySignallingEvent.*;
import static simgsm.station.call.KeySignallingTable.KeySignallingState.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/**
 * Signalling of keys by the mobile (TS 24.008, 5.5.7). A refused key makes later ones meaningless: all are dropped.
 */
public final class KeySignallingTable {
    /** The progress of signalling one key (TS 24.008, 5.5.7), independent of the call's state. */
    public enum KeySignallingState {
        IDLE,
        /** START DTMF is sent. */
        START_PENDING,
        /** START DTMF is acknowledged: the network plays the tone. */
        SOUNDING,
        /** STOP DTMF is sent. */
        STOP_PENDING,
        /** The least pause before the next tone. */
        PAUSING
    }

    /** Events of {@link KeySignallingTable}. */
    public enum KeySignallingEvent {
        NEXT,
        START_ACKNOWLEDGED,
        START_REJECTED,
        /** The tone has had its length, and the key is not held. */
        RELEASED,
        STOP_ACKNOWLEDGED,
        PAUSE_ENDED,
        T336_EXPIRED,
        T337_EXPIRED,
        CALL_ENDED
    }

    /** Actions of {@link KeySignalling}. */
    public enum KeySignallingAction {
        SEND_START,
        SEND_STOP,
        START_T336,
        START_T337,
        START_TONE,
        START_PAUSE,
        STOP_TIMERS,
        REPORT_STARTED,
        REPORT_STOPPING,
        REPORT_COMPLETED,
        REPORT_REFUSED,
        DROP_ALL,
        SEND_NEXT
    }

    public static final StateTable<KeySignallingState, KeySignallingEvent, KeySignallingAction> TABLE =
            new StateTable<>("key signalling", IDLE);

    static {
        TABLE.on(IDLE, NEXT, START_PENDING, SEND_START, START_T336)
                .on(START_PENDING, START_ACKNOWLEDGED, SOUNDING, STOP_TIMERS, START_TONE, REPORT_STARTED)
                .on(START_PENDING, START_REJECTED, IDLE, STOP_TIMERS, REPORT_REFUSED, DROP_ALL)
                .on(START_PENDING, T336_EXPIRED, IDLE, REPORT_REFUSED, DROP_ALL)
                .on(SOUNDING, RELEASED, STOP_PENDING, STOP_TIMERS, SEND_STOP, START_T337, REPORT_STOPPING)
                .on(STOP_PENDING, STOP_ACKNOWLEDGED, PAUSING, STOP_TIMERS, START_PAUSE, REPORT_COMPLETED)
                .on(STOP_PENDING, T337_EXPIRED, IDLE, REPORT_REFUSED, DROP_ALL)
                .on(PAUSING, PAUSE_ENDED, IDLE, SEND_NEXT)
                .on(EnumSet.allOf(KeySignallingState.class), CALL_ENDED, IDLE, STOP_TIMERS, DROP_ALL);
    }

    private KeySignallingTable() {}
}
