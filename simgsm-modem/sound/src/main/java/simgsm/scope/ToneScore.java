package simgsm.scope;

import simgsm.tone.ToneExperiment;

/**
 * Score of a {@link ToneExperiment} by the keys of the undisturbed sound.
 *
 * @param heard keys detected all the same
 * @param missed keys not detected
 * @param invented keys detected without one, or instead of another
 */
public record ToneScore(int heard, int missed, int invented) {
    public static final ToneScore NONE = new ToneScore(0, 0, 0);

    public int keys() {
        return heard + missed;
    }
}
