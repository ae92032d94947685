/**
 * DTMF generator and receivers on 8 kHz, 16-bit mono samples. Arrays in, events out; knows no audio
 * device and no clock, it counts samples.
 *
 * <p>Read first: {@link simgsm.dtmf.DtmfKey}, then {@link simgsm.dtmf.DtmfGenerator}, then {@link simgsm.dtmf.DtmfReceiver}.
 * Call-progress tones are in {@link simgsm.tone}.
 */
package simgsm.dtmf;
