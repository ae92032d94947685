package simgsm.modem;

import simgsm.dtmf.DtmfKey;

/**
 * A modem's treatment of an incoming call. It answers in both cases and sends the tone first; a denied call is then
 * cleared with cause 16.
 */
public record CallDecision(boolean accepted, DtmfKey tone) {}
