/**
 * DTMF generator and receivers on 8 kHz, 16-bit mono samples. Input is arrays, output is events; time is counted in
 * samples, without audio device or clock.
 *
 * <p>Read first: {@link simgsm.dtmf.DtmfKey}, then {@link simgsm.dtmf.DtmfGenerator}, then {@link
 * simgsm.dtmf.DtmfReceiver}. Call-progress tones are in {@link simgsm.tone}.
 */
package simgsm.dtmf;
