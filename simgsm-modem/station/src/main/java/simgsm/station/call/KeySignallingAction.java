package simgsm.station.call;

/** What {@link KeySignalling} does on a transition. */
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
