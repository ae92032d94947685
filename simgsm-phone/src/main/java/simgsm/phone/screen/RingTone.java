package simgsm.phone.screen;

/** How an incoming call sounds. */
public enum RingTone {
    WARBLE,
    BELL,
    RISING,
    SILENT
}
