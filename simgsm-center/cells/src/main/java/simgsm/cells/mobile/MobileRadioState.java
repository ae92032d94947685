package simgsm.cells.mobile;

/** What the radio part of a mobile does (TS 44.018, 3). */
public enum MobileRadioState {
    /** On no channel. */
    IDLE,
    /** CHANNEL REQUEST is sent. */
    ACCESS,
    /** On a channel. */
    DEDICATED,
    /** Between two channels of a cell; layer 3 waits. */
    ASSIGNMENT,
    /** Between two cells; layer 3 waits. */
    HANDOVER
}
