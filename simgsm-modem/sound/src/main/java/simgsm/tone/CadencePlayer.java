package simgsm.tone;

/**
 * Generates a cadence. Bursts rise and fall softly within their length, to avoid clicks; lengths are exact in
 * samples. Owned by one thread.
 */
public final class CadencePlayer {
    private static final int SAMPLES_PER_MILLI = 8;
    private static final int RAMP_SAMPLES = 5 * SAMPLES_PER_MILLI;
    private static final Sine[] SILENCE = {};

    private ToneCadence cadence;
    private long samplesLeft;
    private int step;
    private int sampleInStep;
    private Sine[] sines = SILENCE;

    public CadencePlayer() {}

    /** Plays a cadence from its beginning until {@link #stop}, instead of the current one. */
    public void start(ToneCadence newCadence) {
        begin(newCadence, Long.MAX_VALUE);
    }

    /** Plays a cadence from its beginning for this time, instead of the current one. */
    public void start(ToneCadence newCadence, int totalMillis) {
        begin(newCadence, (long) totalMillis * SAMPLES_PER_MILLI);
    }

    private void begin(ToneCadence newCadence, long samples) {
        cadence = newCadence;
        samplesLeft = samples;
        enter(0);
    }

    public void stop() {
        cadence = null;
    }

    /** True if nothing plays, not even a pause. */
    public boolean isIdle() {
        return cadence == null;
    }

    /** Adds the sound to the frame, clipped to 16 bits. */
    public void addTo(short[] frame) {
        for (int i = 0; i < frame.length && cadence != null; i++) {
            double sum = frame[i] + next();
            frame[i] = (short) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, Math.rint(sum)));
        }
    }

    private void enter(int newStep) {
        step = newStep;
        sampleInStep = 0;
        ToneCadence.Step now = cadence.steps().get(step);
        sines = new Sine[now.hertz().size()];
        for (int i = 0; i < sines.length; i++) {
            sines[i] = new Sine(now.hertz().get(i), ToneLevel.amplitude(now.dbm0()));
        }
    }

    private double next() {
        int length = cadence.steps().get(step).millis() * SAMPLES_PER_MILLI;
        double sum = 0;
        for (Sine sine : sines) {
            sum += sine.next();
        }
        double value = sum * envelope(length);
        sampleInStep++;
        if (--samplesLeft == 0) {
            stop();
        } else if (sampleInStep == length && !cadence.isContinuous()) {
            enter((step + 1) % cadence.steps().size());
        }
        return value;
    }

    private double envelope(int length) {
        long toEnd = cadence.isContinuous() ? samplesLeft - 1 : Math.min(length - 1 - sampleInStep, samplesLeft - 1);
        long fromEdge = Math.min(sampleInStep, toEnd);
        return fromEdge >= RAMP_SAMPLES ? 1 : 0.5 - 0.5 * Math.cos(Math.PI * (fromEdge + 0.5) / RAMP_SAMPLES);
    }
}
