package simgsm.dtmf;

import simgsm.tone.ToneExperiment;

/**
 * How a {@link ToneExperiment} went so far, compared with what is heard of the sound as it is.
 *
 * @param heard keys that are heard all the same
 * @param missed keys that are not
 * @param invented keys that are heard where there is none, or another one
 */
public record ToneScore(int heard, int missed, int invented) {
    public static final ToneScore NONE = new ToneScore(0, 0, 0);

    public int keys() {
        return heard + missed;
    }
}
