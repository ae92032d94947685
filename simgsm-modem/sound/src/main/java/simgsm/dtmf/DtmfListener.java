package simgsm.dtmf;

/** Receives the keys of a {@link DtmfReceiver}, on the thread that calls its {@code accept}. */
public interface DtmfListener {
    /** A key is decided while its tone lasts; called once per key pressed. */
    void keyDecided(DtmfDigit digit);

    /** The tone of the last key has ended: the same key with its whole duration and final measurements. */
    default void keyEnded(DtmfDigit digit) {}
}
