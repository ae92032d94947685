package simgsm.phone.screen;

/** The sound of an incoming call. */
public enum RingTone {
    WARBLE,
    BELL,
    RISING,
    SILENT
}
