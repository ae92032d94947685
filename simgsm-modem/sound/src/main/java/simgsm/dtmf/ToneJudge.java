package simgsm.dtmf;

/**
 * Decides whether two tones that stand out are a key's.
 *
 * <p>A key's two tones begin together, are steady, and keep their frequencies; whatever else is heard must be explained: by
 * a line that was as noisy before, by a codec, by a voice that speaks over the key. A voice or a chord that happens to have
 * two tones in the right places gives itself away by tones that were there before, that waver, or that have company. So no
 * {@link ToneVeto} may hold and one {@link ToneGround} must; their limits were found on the tests' catalogue of recordings,
 * of which they let through all that Q.24 and plain use require, at the smallest number of false keys in many hours of
 * voices and music.
 */
final class ToneJudge {
    private final ToneEvidence evidence = new ToneEvidence();

    /**
     * @param end index just behind the newest sample
     * @param followsKey a key sounds or has sounded just before
     * @return on what ground the tones are a key's, or null if they are none's
     */
    ToneGround judge(ToneFit fit, short[] samples, int end, boolean followsKey) {
        evidence.measure(fit, samples, end, followsKey);
        if (ToneVeto.any(evidence, false)) {
            return null;
        }
        evidence.measureLevels();
        if (!evidence.isHarmony() && ToneGround.ALONE.holds(evidence)) {
            return ToneGround.ALONE;
        }
        evidence.measureSpectrum();
        return ToneVeto.any(evidence, true) ? null : ToneGround.of(evidence);
    }
}
