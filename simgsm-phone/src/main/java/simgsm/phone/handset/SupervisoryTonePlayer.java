package simgsm.phone.handset;

/** Plays a supervisory tone by its cadence, 20 ms at a time. */
final class SupervisoryTonePlayer {
    private static final int SAMPLES_PER_MILLI = 8;
    private static final double SAMPLES_PER_SECOND = 8000;
    /** Some -14 dBm0: softer than keys. */
    private static final double PEAK = 4500;

    private SupervisoryTone tone = SupervisoryTone.NONE;
    private long sample;
    private double phase;

    void start(SupervisoryTone newTone) {
        tone = newTone;
        sample = 0;
        phase = 0;
    }

    boolean isIdle() {
        return tone == SupervisoryTone.NONE;
    }

    /** Mixes the next samples into the frame. */
    void addTo(short[] frame) {
        for (int i = 0; i < frame.length && !isIdle(); i++) {
            int millis = (int) (sample / SAMPLES_PER_MILLI);
            int inCadence = millis % (tone.onMillis + tone.offMillis);
            if (inCadence < tone.onMillis) {
                phase += 2 * Math.PI * tone.hertzAt(inCadence) / SAMPLES_PER_SECOND;
                frame[i] =
                        (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, frame[i] + PEAK * Math.sin(phase)));
            }
            sample++;
            if (millis >= tone.totalMillis) {
                start(SupervisoryTone.NONE);
            }
        }
    }
}
