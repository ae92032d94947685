package simgsm.station.call;

import static simgsm.station.call.KeySignallingAction.*;
import static simgsm.station.call.KeySignallingEvent.*;
import static simgsm.station.call.KeySignallingState.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/** Signalling of keys by the mobile (TS 24.008, 5.5.7). A refused key makes those after it meaningless: all are dropped. */
public final class KeySignallingTable {
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
