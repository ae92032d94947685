package simgsm.dtmf;

/** The grounds on which two tones are taken for a key's; one suffices, if no {@link ToneVeto} holds. */
enum ToneGround {
    /** Nothing else is in the line, which is how most keys come. Needs no spectrum. */
    ALONE {
        @Override
        boolean holds(ToneEvidence e) {
            return e.shareOfAll > 0.93
                    && e.coherence > 0.975
                    && e.ripple < 1.35
                    && (e.followsKey || e.allBefore < 0.06)
                    && (e.error < 1.2 || e.error < 2.1 && e.isSteadyAndNew());
        }
    },

    /** Some noise, mains, dial tone, direct current: nothing much in the tones' band. */
    CLEAN {
        @Override
        boolean holds(ToneEvidence e) {
            return e.isFresh()
                    && e.share > 0.9
                    && e.newShareOfAll > 0.8
                    && e.coherence > 0.93
                    && e.ripple < 1.5
                    && e.fit.sinceOnset < 22
                    && (e.error < 1.2
                            || e.error < 2.1 && e.coherence > 0.96 && e.line < -14 && e.isSteadyAndNew()
                            || e.error < 2.1
                                    && e.fit.sinceOnset < 14
                                    && e.isStationary()
                                    && e.residue.evenness() > EVEN);
        }
    },

    /** Behind a codec that mangled the beginning: some tone before, but nothing else at all. */
    SETTLED {
        @Override
        boolean holds(ToneEvidence e) {
            return e.share > 0.985
                    && e.newShareOfAll > (e.tonesBefore < 0.003 ? 0.55 : 0.7)
                    && e.line < -18
                    && e.coherence > 0.83
                    && Math.min(e.fit.steadiness[0], e.fit.steadiness[1]) > 0.88
                    && e.error < 1
                    && e.twist > -9
                    && e.twist < 7
                    && e.tonesBefore < 0.5
                    && e.fit.sinceOnset < (e.tonesBefore < 0.003 ? 28 : 20);
        }
    },

    /**
     * After an interruption right at the beginning: as pure as a key alone, and before it nothing but the same two tones
     * and the hole, which smears them a little.
     */
    RESUMED {
        @Override
        boolean holds(ToneEvidence e) {
            return e.share > 0.98
                    && e.shareOfAll > 0.93
                    && e.coherence > 0.98
                    && e.ripple < 1.2
                    && e.error < 2
                    && e.line < -20
                    && e.tonesBefore < 1
                    && e.restBefore < 0.25 * e.tonesBefore
                    && e.allBefore < 0.7
                    && Math.abs(e.twist) < 10
                    && e.fit.sinceOnset < 22;
        }
    },

    /** Behind a codec, out of silence: the tones waver and are not in balance yet. */
    SETTLING {
        @Override
        boolean holds(ToneEvidence e) {
            return e.share > 0.97
                    && e.newShareOfAll > 0.75
                    && e.tonesBefore < 0.003
                    && e.restBefore < 0.05
                    && e.line < -13.5
                    && e.coherence > 0.45
                    && e.fit.sinceOnset < (e.error < 0.6 ? 26 : 18)
                    && e.error < 2.1
                    && e.twist > -12.5
                    && e.twist < 9;
        }
    },

    /**
     * In noise: as loud before and no louder, without lines, and the tones waver no more than so much noise makes them.
     * The limits leave out one in a hundred spectra of white noise.
     */
    IN_NOISE {
        @Override
        boolean holds(ToneEvidence e) {
            return e.share > 0.28
                    && e.newShare > 0.8
                    && e.isStationary()
                    && e.lineShare < 0.16
                    && e.line < -3
                    && e.tonesBefore < 0.04 + 0.4 * e.restBefore
                    && e.coherence > 0.58
                    && e.isExplainedByNoise(0)
                    && e.isExplainedByNoise(1)
                    && e.error < (e.coherence > 0.9 ? 2.1 : 1)
                    && Math.abs(e.twist) < 10.5
                    && e.fit.sinceOnset < (e.restBefore > 0.9 ? 24 : 18)
                    && e.residue.evenness() > EVEN;
        }
    },

    /** Over a din that goes on as it was before, or mangled by codecs in a row: noise of any colour, but no lines. */
    IN_DIN {
        @Override
        boolean holds(ToneEvidence e) {
            return e.share > 0.6
                    && e.newShare > 0.93
                    && e.newLine < -9
                    && e.error < 0.9
                    && e.coherence > 0.72
                    && e.tonesBefore < 0.13
                    && Math.abs(e.twist) < 6
                    && e.fit.sinceOnset < 14
                    && e.residue.evenness() > 0.46;
        }
    },

    /** Over a voice or music that goes on as it was before: with lines, but none of them new. */
    OVER_LINES {
        @Override
        boolean holds(ToneEvidence e) {
            return e.share > 0.6
                    && e.newShare > 0.93
                    && e.newLine < -12
                    && e.error < 0.8
                    && e.coherence > 0.74
                    && e.tonesBefore < 0.13
                    && Math.abs(e.twist) < 6
                    && e.fit.sinceOnset < 12.6;
        }
    },

    /** Under a voice or music that covers one of the tones; the other is as clear as a key's. */
    HALF_COVERED {
        @Override
        boolean holds(ToneEvidence e) {
            int clear = e.fit.coherence[0] > e.fit.coherence[1] ? 0 : 1;
            int covered = 1 - clear;
            return e.share > 0.4
                    && Math.abs(e.twist) < 4.5
                    && e.fit.sinceOnset < 30
                    && e.fit.coherence[clear] > 0.97
                    && Math.abs(e.fit.error[clear]) < 0.003
                    && e.before(clear) < 0.03
                    && e.fit.coherence[covered] > 0.7
                    && e.fit.steadiness[covered] > 0.92
                    && Math.abs(e.fit.error[covered]) < 0.006
                    && e.before(covered) < 0.4;
        }
    };

    /** Of a hundred spectra of white noise ninety-nine are more even. */
    private static final double EVEN = 0.47;

    private static final ToneGround[] ALL = values();

    abstract boolean holds(ToneEvidence evidence);

    /** The first that holds, or null. The evidence must be complete. */
    static ToneGround of(ToneEvidence evidence) {
        for (ToneGround ground : ALL) {
            if (ground.holds(evidence)) {
                return ground;
            }
        }
        return null;
    }
}
