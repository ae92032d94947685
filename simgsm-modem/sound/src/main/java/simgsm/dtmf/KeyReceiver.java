package simgsm.dtmf;

/** Detects keys in 8 kHz, 16-bit mono speech, streaming in chunks of any size. Owned by one thread. */
public interface KeyReceiver {
    /** The next {@code samples[from..to)} of the stream. */
    void accept(short[] samples, int from, int to);

    /** The next samples of the stream. */
    default void accept(short[] samples) {
        accept(samples, 0, samples.length);
    }

    /** The last measurement, with the limits for the tones. */
    ToneLevels levels();

    /** Ends the stream, and a key that still sounds. */
    void finish();

    /** Begins a new stream; a key in progress is dropped without an event. */
    void reset();
}
