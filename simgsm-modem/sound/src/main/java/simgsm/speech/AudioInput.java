package simgsm.speech;

/** A source of speech at its own pace, such as a microphone. Never blocks. */
public interface AudioInput extends AutoCloseable {
    /** Has no speech. */
    AudioInput SILENT = new AudioInput() {
        @Override
        public void begin() {}

        @Override
        public void read(short[] frame) {}

        @Override
        public void close() {}
    };

    /** Drops the speech of before: a call begins or goes on. */
    void begin();

    /** Fills a silent frame of 160 samples with the next 20 ms, if there are any. */
    void read(short[] frame);

    @Override
    void close();
}
