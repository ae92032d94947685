package simgsm.speech;

/** An output for speech. Never blocks: speech beyond what the device can take is dropped. */
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

    /** @param samples 8 kHz mono, copied before the call returns */
    void play(short[] samples);

    /** Whether a device is open. */
    boolean isAudible();

    @Override
    void close();
}
