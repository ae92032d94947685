package simgsm.phone.screen;

/** How a phone sends its keys in a call. */
public enum KeyMode {
    /** As tones in its speech, as in the paper. */
    IN_BAND,
    /** As START DTMF and STOP DTMF, from which the network makes the tones, as in GSM. */
    SIGNALLED
}
