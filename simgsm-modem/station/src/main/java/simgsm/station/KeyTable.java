package simgsm.station;

import static simgsm.station.KeyAction.*;
import static simgsm.station.KeyEvent.*;
import static simgsm.station.KeyState.*;

import java.util.EnumSet;
import simgsm.state.StateTable;

/** Signalling of keys by the mobile (TS 24.008, 5.5.7): START DTMF, STOP DTMF and their acknowledgements. */
final class KeyTable {
    static final StateTable<KeyState, KeyEvent, KeyAction> ROWS = new StateTable<KeyState, KeyEvent, KeyAction>(
                    "key signalling", KeyState.IDLE)
            .on(EnumSet.of(IDLE), NEXT, START_PENDING, SEND_START, START_T336)
            .on(EnumSet.of(START_PENDING), START_ACKNOWLEDGED, SOUNDING, STOP_TIMERS, START_TONE, TELL_SOUNDS)
            .on(EnumSet.of(START_PENDING), START_REJECTED, IDLE, STOP_TIMERS, TELL_REFUSED, FORGET_ALL)
            .on(EnumSet.of(START_PENDING), T336_EXPIRED, IDLE, TELL_REFUSED, FORGET_ALL)
            .on(EnumSet.of(SOUNDING), LET_GO, STOP_PENDING, STOP_TIMERS, SEND_STOP, START_T337, TELL_LET_GO)
            .on(EnumSet.of(STOP_PENDING), STOP_ACKNOWLEDGED, PAUSING, STOP_TIMERS, START_PAUSE, TELL_LEFT)
            .on(EnumSet.of(STOP_PENDING), T337_EXPIRED, IDLE, TELL_REFUSED, FORGET_ALL)
            .on(EnumSet.of(PAUSING), PAUSE_OVER, IDLE, SEND_NEXT)
            .on(EnumSet.allOf(KeyState.class), CALL_ENDED, IDLE, STOP_TIMERS, FORGET_ALL);

    private KeyTable() {}
}
