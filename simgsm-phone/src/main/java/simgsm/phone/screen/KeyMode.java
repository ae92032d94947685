package simgsm.phone.screen;

/** The way a phone sends keys in a call. */
public enum KeyMode {
    /** The phone sends tones in its speech, as in the paper. */
    IN_BAND,
    /** The phone sends START DTMF and STOP DTMF, and the network makes the tones, as in GSM. */
    SIGNALLED
}
