package simgsm.station;

enum KeyEvent {
    NEXT,
    START_ACKNOWLEDGED,
    START_REJECTED,
    /** The key has sounded as long as it should, and nobody holds it. */
    LET_GO,
    STOP_ACKNOWLEDGED,
    PAUSE_OVER,
    T336_EXPIRED,
    T337_EXPIRED,
    CALL_ENDED
}
