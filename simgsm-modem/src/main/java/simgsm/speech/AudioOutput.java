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

    /**
     * The system's own sound device. Returns at once; until the device is open, and for good when there is none, it is
     * as silent as {@link #SILENT}.
     */
    static AudioOutput open() {
        return new SoundCard();
    }

    /** Like {@link #open}, but the device is left alone until something is to be played. */
    static AudioOutput openWhenPlayed() {
        return new LateOutput(AudioOutput::open);
    }

    /** @param samples 8 kHz mono, taken over before the call returns */
    void play(short[] samples);

    /** Whether a device is open now. */
    boolean isAudible();

    @Override
    void close();
}
