package simgsm.speech;

/** Where speech is heard. Never blocks: sound that comes faster than it can be played is dropped. */
public interface AudioOutput extends AutoCloseable {
    /** The silent twin. */
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

    /** The system's own sound device, or {@link #SILENT} when there is none. */
    static AudioOutput open() {
        return SILENT;
    }

    /** @param samples 8 kHz mono, taken over before the call returns */
    void play(short[] samples);

    /** Whether there is a device. */
    boolean isAudible();

    @Override
    void close();
}
