package simgsm.speech;

/** Where speech is heard. Never blocks: sound that comes faster than it can be played is dropped. */
public interface AudioOutput extends AutoCloseable {
    /** Plays nothing. */
    AudioOutput SILENT = new AudioOutput() {
        @Override
        public void play(short[] samples) {}

        @Override
        public boolean isAudible() {
            return false;
        }

        @Override
        public void close() {}
    };

    /** @param samples 8 kHz mono, taken over before the call returns */
    void play(short[] samples);

    /** Whether a device is open now. */
    boolean isAudible();

    @Override
    void close();
}
