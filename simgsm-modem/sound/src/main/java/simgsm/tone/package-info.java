/**
 * Call-progress tones, the level of a tone, and the experiments that a tone scope does to sound: noise, shifted frequencies, a codec. 8 kHz,
 * 16-bit mono samples; knows no audio device and no clock, it counts samples.
 *
 * <p>Read first: {@link simgsm.tone.ToneSet} for the tones of a country's network, {@link simgsm.tone.Disturber} for the experiments.
 */
package simgsm.tone;
