package simgsm.scope;

/**
 * The state of a tone scope: the trace shown, and the way it is shown. Traces arrive at any rate; a frozen scope
 * keeps its trace, and asks for no further key. Not thread-safe.
 */
public final class ScopeInstrument {
    /** Milliseconds of the wave in {@link Picture#LEVELS}. */
    public static final double WAVE_MILLIS = 24;
    /** Milliseconds of a spectrogram. */
    public static final double SPECTROGRAM_MILLIS = 2000;

    public static final double LEAST_HERTZ = 600;
    public static final double MOST_HERTZ = 1750;

    /** The kinds of picture. */
    public enum Picture {
        /** The wave and the levels of the eight tones. */
        LEVELS,
        /** Power over time and frequency. */
        SPECTROGRAM,
        /** The spoken word that was compared last, in its mel bands, and its distances. */
        WORD
    }

    private final ScopeCursors onWave = new ScopeCursors(WAVE_MILLIS, 0, 0);
    private final ScopeCursors onSpectrogram = new ScopeCursors(SPECTROGRAM_MILLIS, LEAST_HERTZ, MOST_HERTZ);
    private final KeyPrediction prediction = new KeyPrediction();
    private ToneTrace newest = ToneTrace.EMPTY;
    private ToneTrace frozen = ToneTrace.EMPTY;
    private boolean isFrozen;
    private boolean hasCursors;
    private boolean isComparing;
    private boolean isConcealed;
    private Picture picture = Picture.LEVELS;

    public ScopeInstrument() {}

    /** @return true if the picture changes */
    public boolean show(ToneTrace trace) {
        ToneTrace before = trace();
        newest = trace;
        if (!isFrozen) {
            prediction.hear(trace);
        }
        return trace() != before;
    }

    /** The trace to draw. */
    public ToneTrace trace() {
        return isFrozen ? frozen : prediction.held().orElse(newest);
    }

    /** Keeps the current trace, or continues with the newest. */
    public void freeze(boolean freeze) {
        frozen = trace();
        isFrozen = freeze;
    }

    public boolean isFrozen() {
        return isFrozen;
    }

    public void choose(Picture newPicture) {
        picture = newPicture;
    }

    public Picture picture() {
        return picture;
    }

    /** Cursors of the selected picture; drawn only if {@link #hasCursors}. */
    public ScopeCursors cursors() {
        return picture == Picture.SPECTROGRAM ? onSpectrogram : onWave;
    }

    public void setCursors(boolean shown) {
        hasCursors = shown;
    }

    public boolean hasCursors() {
        return hasCursors && picture != Picture.WORD;
    }

    /** Draws the sound before the experiment behind that after it. */
    public void compare(boolean comparing) {
        isComparing = comparing;
    }

    public boolean isComparing() {
        return isComparing;
    }

    /** Hides keys without a question, during another scope's. */
    public void conceal(boolean concealed) {
        isConcealed = concealed;
    }

    /** True if keys are hidden, for a question of this scope or of another. */
    public boolean isHiding() {
        return isConcealed || prediction.isHiding();
    }

    /** The questions for keys to read off the picture. */
    public KeyPrediction prediction() {
        return prediction;
    }
}
