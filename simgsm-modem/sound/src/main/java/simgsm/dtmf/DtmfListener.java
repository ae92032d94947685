package simgsm.dtmf;

/** Told what a {@link DtmfReceiver} hears, on the thread that feeds it. */
public interface DtmfListener {
    /** A key is certain; its tone still sounds. Once per key pressed. */
    void keyDecided(DtmfDigit digit);

    /** The tone of the key last decided has ended: the same key with its whole duration and its final measurements. */
    default void keyEnded(DtmfDigit digit) {}
}
