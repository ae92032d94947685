package simgsm.dtmf;

/** What keeps two tones that stand out from being a key's, whatever speaks for them. */
enum ToneVeto {
    /** They wander in phase as noise does, not as tones do. */
    INCOHERENT(false) {
        @Override
        boolean holds(ToneEvidence e) {
            return e.coherence < 0.45;
        }
    },

    /** They sounded before all that is remembered, so nobody heard them begin. */
    BEGAN_UNSEEN(false) {
        @Override
        boolean holds(ToneEvidence e) {
            return e.fit.open && e.fit.sinceOnset >= ToneFit.SPAN - 2;
        }
    },

    /** Noise blurs their beginning, so that a tone too short for a key could be taken for a longer one. */
    TOO_EARLY_IN_NOISE(false) {
        @Override
        boolean holds(ToneEvidence e) {
            return e.coherence < 0.9 && e.fit.sinceOnset < 11
                    || e.coherence < 0.8 && e.fit.sinceOnset < 12
                    || e.coherence < 0.7 && e.fit.sinceOnset < 14;
        }
    },

    /** One is 12.7 dB or more louder than the other. Keys stay within 10 (Q.24: 8), 15 must not count. */
    TWISTED(false) {
        @Override
        boolean holds(ToneEvidence e) {
            return Math.abs(e.twist) > 12.7;
        }
    },

    /** One is the other's octave: a string or a voice. No key comes nearer than 0.65 %, 1.8 % off either way. */
    OCTAVE(false) {
        @Override
        boolean holds(ToneEvidence e) {
            return Math.abs(e.fit.hertz[1] / e.fit.hertz[0] - 2) < 0.003;
        }
    },

    /** Twice a tone's frequency is there, too. Strings and voices have overtones, keys have none. */
    OVERTONE(true) {
        @Override
        boolean holds(ToneEvidence e) {
            double hertz = e.residue.lineHertz;
            return e.line > -11
                    && (Math.abs(hertz - 2 * e.fit.hertz[0]) < OCTAVE_HERTZ
                            || Math.abs(hertz - 2 * e.fit.hertz[1]) < OCTAVE_HERTZ);
        }
    },

    /**
     * Their frequencies are to each other as two of a voice's harmonics are, and others of its harmonics are there, too: the
     * third and seventh of a voice at 232 Hz lie only 0.4 % beside A, the fourth and seventh 0.9 % beside 1, 5, 9 and D.
     */
    HARMONICS(true) {
        @Override
        boolean holds(ToneEvidence e) {
            return e.isHarmony() && e.family() > -26 && (e.residue.evenness() < 0.42 || e.isFamily());
        }
    },

    /**
     * One is fainter than -38 dBm0, below all that Q.24 asks for, much in their band sounds as well, and most of what sounds
     * lies outside it: that is how parts of a voice's consonants come.
     */
    FAINT_IN_DIN(true) {
        @Override
        boolean holds(ToneEvidence e) {
            return e.weakerDbm0 < -38 && e.share < 0.8 && e.shareOfAll < 0.25;
        }
    },

    /** They keep their strength but not their frequencies: sirens, whistles, chirps. */
    GLIDING(false) {
        @Override
        boolean holds(ToneEvidence e) {
            return e.coherence < 0.96 && e.ripple < 1.06;
        }
    };

    /** Hertz by which a line may miss twice a tone's frequency and still be its octave. */
    private static final double OCTAVE_HERTZ = 35;

    private static final ToneVeto[] ALL = values();

    private final boolean needsSpectrum;

    ToneVeto(boolean needsSpectrum) {
        this.needsSpectrum = needsSpectrum;
    }

    abstract boolean holds(ToneEvidence evidence);

    /** Does any hold of those that need, or do not need, the spectrum? */
    static boolean any(ToneEvidence evidence, boolean withSpectrum) {
        for (ToneVeto veto : ALL) {
            if (veto.needsSpectrum == withSpectrum && veto.holds(evidence)) {
                return true;
            }
        }
        return false;
    }
}
