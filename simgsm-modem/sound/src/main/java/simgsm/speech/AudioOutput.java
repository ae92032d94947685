package simgsm.speech;

/** An output for speech. Never blocks: speech beyond the device's capacity is dropped. */
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

    /** True if a device is open. */
    boolean isAudible();

    @Override
    void close();
}
