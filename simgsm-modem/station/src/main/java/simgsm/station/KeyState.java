package simgsm.station;

/** Where the signalling of one key stands (TS 24.008, 5.5.7); the call's own state is untouched by it. */
enum KeyState {
    IDLE,
    /** START DTMF is sent. */
    START_PENDING,
    /** The network has acknowledged it: the tone sounds at the far end. */
    SOUNDING,
    /** STOP DTMF is sent. */
    STOP_PENDING,
    /** The tone is over; the next may not begin yet. */
    PAUSING
}
