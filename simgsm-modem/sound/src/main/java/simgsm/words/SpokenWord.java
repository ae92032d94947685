package simgsm.words;

import java.io.DataInput;
import java.io.DataOutput;
import java.io.IOException;
import java.util.List;

/**
 * A spoken word for comparison: for each 10 ms the cepstral coefficients C1 to C12 of ETSI ES 201 108, 4.2.10, without
 * the word's mean, liftered, and their slopes over five frames.
 */
public final class SpokenWord {
    static final int CEPSTRA = 12;
    static final int FEATURES = 2 * CEPSTRA;

    /** Shortest and longest word, in frames. */
    private static final int LEAST = 5;

    private static final int MOST = 300;
    private static final double SLOPE_WEIGHT = 3;
    /** Quieter bands are equal: the noise of the codecs, so that digital silence around a word resembles a quiet room. */
    private static final double LEAST_BAND = 100;

    private static final double[][] COSINE = new double[CEPSTRA][MelSpectrum.BANDS];

    static {
        for (int i = 0; i < CEPSTRA; i++) {
            for (int band = 0; band < MelSpectrum.BANDS; band++) {
                COSINE[i][band] = Math.cos(Math.PI * (i + 1) * (band + 0.5) / MelSpectrum.BANDS)
                        * (1 + 11 * Math.sin(Math.PI * (i + 1) / 22));
            }
        }
    }

    private final float[][] features;

    private SpokenWord(float[][] features) {
        this.features = features;
    }

    /** @param frames of the word alone, as {@link WordCutter} cuts it */
    public static SpokenWord of(List<SpeechFrame> frames) {
        int length = frames.size();
        double[][] cepstra = new double[length][CEPSTRA];
        double[] mean = new double[CEPSTRA];
        for (int t = 0; t < length; t++) {
            float[] bands = frames.get(t).bands();
            for (int band = 0; band < bands.length; band++) {
                double log = Math.log(Math.max(LEAST_BAND, bands[band]));
                for (int i = 0; i < CEPSTRA; i++) {
                    cepstra[t][i] += log * COSINE[i][band];
                }
            }
            for (int i = 0; i < CEPSTRA; i++) {
                mean[i] += cepstra[t][i] / length;
            }
        }
        float[][] features = new float[length][FEATURES];
        for (int t = 0; t < length; t++) {
            for (int i = 0; i < CEPSTRA; i++) {
                features[t][i] = (float) (cepstra[t][i] - mean[i]);
                features[t][CEPSTRA + i] = (float) (SLOPE_WEIGHT * slope(cepstra, t, i));
            }
        }
        return new SpokenWord(features);
    }

    private static double slope(double[][] cepstra, int t, int i) {
        double sum = 0;
        for (int d = 1; d <= 2; d++) {
            int after = Math.min(cepstra.length - 1, t + d);
            int before = Math.max(0, t - d);
            sum += d * (cepstra[after][i] - cepstra[before][i]);
        }
        return sum / 10;
    }

    /** Duration in frames of 10 ms. */
    public int length() {
        return features.length;
    }

    double distance(int frame, SpokenWord other, int otherFrame) {
        float[] a = features[frame];
        float[] b = other.features[otherFrame];
        float sum = 0;
        for (int i = 0; i < FEATURES; i++) {
            float difference = a[i] - b[i];
            sum += difference * difference;
        }
        return Math.sqrt(sum);
    }

    /** Writes the word for {@link #read}: the number of frames, then 24 floats a frame. */
    public void write(DataOutput out) throws IOException {
        out.writeInt(features.length);
        for (float[] frame : features) {
            for (float value : frame) {
                out.writeFloat(value);
            }
        }
    }

    /** @throws IOException also for a length outside 5 to 300 frames */
    public static SpokenWord read(DataInput in) throws IOException {
        int length = in.readInt();
        if (length < LEAST || length > MOST) {
            throw new IOException("template of " + length + " frames, expected " + LEAST + " to " + MOST);
        }
        float[][] features = new float[length][FEATURES];
        for (float[] frame : features) {
            for (int i = 0; i < FEATURES; i++) {
                frame[i] = in.readFloat();
            }
        }
        return new SpokenWord(features);
    }
}
