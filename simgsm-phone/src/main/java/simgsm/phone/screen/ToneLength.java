package simgsm.phone.screen;

/** The length of a key's tone in a call. */
public enum ToneLength {
    /** The tone lasts while the key is held, 70 ms at least. */
    HELD(0),
    SHORT(100),
    LONG(300);

    private final int millis;

    ToneLength(int millis) {
        this.millis = millis;
    }

    /** Length of the tone; 0 for as long as the key is held. */
    public int millis() {
        return millis;
    }
}
