package simgsm.modem;

import simgsm.dtmf.DtmfKey;

/**
 * How a modem treats an incoming call. Either way it answers, and the tone is the first thing that the caller hears; a
 * denied call is then cleared with cause 16.
 */
public record CallDecision(boolean accepted, DtmfKey tone) {}
