package simgsm.words;

import java.util.function.Consumer;

/**
 * Makes a {@link SpeechFrame} every 10 ms from 8 kHz speech (ETSI ES 201 108, 4.2.1 to 4.2.9), independent of the chunk
 * size. Owned by one thread.
 */
public final class FrontEnd {
    /** Samples from frame to frame, 10 ms. */
    public static final int SHIFT = 80;

    private static final double OFFSET_POLE = 0.999;

    private final Consumer<SpeechFrame> frames;
    private final double[] window = new double[MelSpectrum.FRAME + 1];
    private int filled;
    private double input;
    private double output;

    public FrontEnd(Consumer<SpeechFrame> frames) {
        this.frames = frames;
    }

    /** The mel band around a frequency; fractions are between the centres of two. */
    public static double band(double hertz) {
        return (MelSpectrum.mel(hertz) - MelSpectrum.mel(MelSpectrum.LOWEST_HERTZ)) / MelSpectrum.STEP - 1;
    }

    public void accept(short[] samples) {
        for (short sample : samples) {
            output = sample - input + OFFSET_POLE * output;
            input = sample;
            window[1 + filled++] = output;
            if (filled == MelSpectrum.FRAME) {
                frames.accept(frame());
                System.arraycopy(window, SHIFT, window, 0, window.length - SHIFT);
                filled -= SHIFT;
            }
        }
    }

    private SpeechFrame frame() {
        double sum = 1;
        for (int i = 1; i < window.length; i++) {
            sum += window[i] * window[i];
        }
        return new SpeechFrame(MelSpectrum.of(window), 10 * Math.log10(sum / MelSpectrum.FRAME));
    }
}
