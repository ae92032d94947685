package simgsm.station.call;

/** How far the signalling of one key is (TS 24.008, 5.5.7); independent of the call's state. */
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
