package simgsm.modem;

import simgsm.dtmf.DtmfKey;

/**
 * What becomes of a call that has come. Either way it is answered and the tone is the first thing that the caller hears;
 * a denied call is then cleared with cause 16 once the tone has left.
 */
public record CallDecision(boolean accepted, DtmfKey tone) {
    public static CallDecision accept(DtmfKey tone) {
        return new CallDecision(true, tone);
    }

    public static CallDecision deny(DtmfKey tone) {
        return new CallDecision(false, tone);
    }
}
