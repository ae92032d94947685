package simgsm.station;

enum KeyAction {
    SEND_START,
    SEND_STOP,
    START_T336,
    START_T337,
    START_TONE,
    START_PAUSE,
    STOP_TIMERS,
    TELL_SOUNDS,
    TELL_LET_GO,
    TELL_LEFT,
    /** A key that is missing spoils what follows it, so all that wait are dropped. */
    TELL_REFUSED,
    FORGET_ALL,
    SEND_NEXT
}
