package simgsm.dtmf;

/** Hears keys in 8 kHz, 16-bit mono speech, streaming in chunks of any size. Owned by one thread. */
public interface KeyReceiver {
    /** The next {@code samples[from..to)} of the stream. */
    void accept(short[] samples, int from, int to);

    /** The next samples of the stream. */
    default void accept(short[] samples) {
        accept(samples, 0, samples.length);
    }

    /** What was measured last, with the limits that the tones must reach. */
    ToneLevels levels();

    /** The stream ends here: a key that still sounds ends, too. */
    void finish();

    /** Begins a new stream; a key in progress is dropped without an event. */
    void reset();
}
