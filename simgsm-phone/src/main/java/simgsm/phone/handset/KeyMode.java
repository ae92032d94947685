package simgsm.phone.handset;

/** How a phone sends its keys in a call. */
public enum KeyMode {
    /** As sound among its speech, as the paper has it. */
    IN_BAND,
    /** As START DTMF and STOP DTMF, from which the network makes the sound, as GSM has it. */
    SIGNALLED
}
