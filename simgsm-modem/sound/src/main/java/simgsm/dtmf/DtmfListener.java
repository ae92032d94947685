package simgsm.dtmf;

/** Receives the keys of a {@link DtmfReceiver}, on the thread that calls its {@code accept}. */
public interface DtmfListener {
    /** A key is decided while its tone lasts; once per key pressed. */
    void keyDecided(DtmfDigit digit);

    /** The tone of the key last decided has ended: the same key with its whole duration and its final measurements. */
    default void keyEnded(DtmfDigit digit) {}
}
